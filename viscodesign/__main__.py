"""`python -m viscodesign`: the command line without its installed script."""

import sys

from viscodesign.cli.main import main

if __name__ == "__main__":
    sys.exit(main())
