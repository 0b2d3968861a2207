"""The real pump: a syringe driven by a servo, the boards that command it, and its stand-ins."""
