; made from e11f1a684d7c59f194a3920991c93590a5ed79c8b82a8a7b262a758c6a711c6b
define i64 @residual(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @residual.0(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8)
  ret i64 0
}

define internal i32 @residual.0(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.r, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.633 = alloca ptr, align 8
  store ptr null, ptr %.633, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.671 = alloca ptr, align 8
  store ptr null, ptr %.671, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.33 = load i64, ptr %arg.layout, align 8
  %.116161 = icmp sgt i64 %.33, -1
  br i1 %.116161, label %B62.if.preheader, label %B78

B62.if.preheader:
  %storemerge = add nuw i64 %.33, 1
  %0 = add nuw i64 %.33, 2
  %smin = call i64 @llvm.smin.i64(i64 %storemerge, i64 1)
  %1 = sub i64 %0, %smin
  %2 = shl nuw i64 %1, 3
  call void @llvm.memset.p0.i64(ptr align 8 %arg.r, i8 0, i64 %2, i1 false)
  br label %B78

B78:
  %.163 = getelementptr i8, ptr %arg.layout, i64 32
  %.164 = load i64, ptr %.163, align 8
  %.245170.not = icmp slt i64 %.164, 1
  br i1 %.245170.not, label %B846, label %B132.if

B288:
  %.312 = getelementptr i8, ptr %5, i64 56
  %.313 = load i64, ptr %.312, align 8
  %.315 = getelementptr double, ptr %arg.numbers, i64 %.313
  %.322 = getelementptr i8, ptr %5, i64 48
  %.323 = load i64, ptr %.322, align 8
  %.325 = getelementptr i32, ptr %arg.idx, i64 %.323
  %.329 = getelementptr i8, ptr %5, i64 64
  %.330 = load i64, ptr %.329, align 8
  %.332 = getelementptr i32, ptr %arg.rows, i64 %.330
  %.345 = load i64, ptr %5, align 8
  %.347 = mul nsw i64 %.345, %.298
  %.429167.not = icmp slt i64 %.347, 1
  br i1 %.429167.not, label %B847, label %B532.if

B626:
  %.506 = load i64, ptr %5, align 8
  %.586164.not = icmp slt i64 %.506, 1
  br i1 %.586164.not, label %B847, label %B684.if.lr.ph

B684.if.lr.ph:
  %.661 = getelementptr i8, ptr %5, i64 64
  br label %B684.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B846 ], [ %.675, %B686.endif.if ], [ %.637, %B686.if ]
  ret i32 %common.ret.op

B846:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B847:
  %exitcond178.not = icmp eq i64 %.164, %.258
  br i1 %exitcond178.not, label %B846, label %B132.if

B132.if:
  %.188.0171 = phi i64 [ %.258, %B847 ], [ 0, %B78 ]
  %.258 = add nuw nsw i64 %.188.0171, 1
  %3 = mul nuw nsw i64 %.188.0171, 11
  %4 = add nuw nsw i64 %3, 8
  %5 = getelementptr i64, ptr %arg.layout, i64 %4
  %.291 = getelementptr i8, ptr %5, i64 32
  %.292 = load i64, ptr %.291, align 8
  %.296 = getelementptr i8, ptr %5, i64 8
  %.297 = load i64, ptr %.296, align 8
  %.298 = mul nsw i64 %.297, %.292
  %.305 = getelementptr i8, ptr %5, i64 80
  %.306 = load i64, ptr %.305, align 8
  %.307 = icmp eq i64 %.306, -1
  br i1 %.307, label %B288, label %B626

B532.if:
  %.373.0168 = phi i64 [ %.442, %B532.if ], [ 0, %B288 ]
  %.442 = add nuw nsw i64 %.373.0168, 1
  %.468 = getelementptr i32, ptr %.332, i64 %.373.0168
  %.469 = load i32, ptr %.468, align 4
  %.471 = sext i32 %.469 to i64
  %.472 = getelementptr double, ptr %arg.r, i64 %.471
  %.473 = load double, ptr %.472, align 8
  %.475 = getelementptr double, ptr %.315, i64 %.373.0168
  %.476 = load double, ptr %.475, align 8
  %.478 = getelementptr i32, ptr %.325, i64 %.373.0168
  %.479 = load i32, ptr %.478, align 4
  %.481 = sext i32 %.479 to i64
  %.482 = getelementptr double, ptr %arg.Y, i64 %.481
  %.483 = load double, ptr %.482, align 8
  %.484 = fmul contract double %.476, %.483
  %.485 = fadd contract double %.473, %.484
  store double %.485, ptr %.472, align 8
  %exitcond177.not = icmp eq i64 %.347, %.442
  br i1 %exitcond177.not, label %B847, label %B532.if

B684.if:
  %.530.0165 = phi i64 [ 0, %B684.if.lr.ph ], [ %.599, %B686.endif.endif ]
  %.599 = add nuw nsw i64 %.530.0165, 1
  store ptr null, ptr %.633, align 8
  %.637 = call i32 @run_group.1(ptr nonnull %.633, ptr nonnull %excinfo.1, ptr nonnull %arg.layout, i64 %4, i64 0, i64 %.530.0165, ptr %arg.kernels, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.local, ptr %arg.out)
  switch i32 %.637, label %B686.if [
    i32 -2, label %B686.endif
    i32 0, label %B686.endif
  ]

B686.if:
  %.645 = icmp sgt i32 %.637, 0
  %.638 = load ptr, ptr %excinfo.1, align 8
  %.646 = select i1 %.645, ptr %.638, ptr undef
  store ptr %.646, ptr %excinfo, align 8
  br label %common.ret

B686.endif:
  %.662 = load i64, ptr %.661, align 8
  %.664 = mul nsw i64 %.530.0165, %.298
  %6 = getelementptr i32, ptr %arg.rows, i64 %.662
  %.667 = getelementptr i32, ptr %6, i64 %.664
  store ptr null, ptr %.671, align 8
  %.675 = call i32 @scatter.2(ptr nonnull %.671, ptr nonnull %excinfo.2, i64 %.298, ptr %.667, ptr %arg.out, ptr %arg.r)
  switch i32 %.675, label %B686.endif.if [
    i32 -2, label %B686.endif.endif
    i32 0, label %B686.endif.endif
  ]

B686.endif.if:
  %.683 = icmp sgt i32 %.675, 0
  %.676 = load ptr, ptr %excinfo.2, align 8
  %.684 = select i1 %.683, ptr %.676, ptr undef
  store ptr %.684, ptr %excinfo, align 8
  br label %common.ret

B686.endif.endif:
  %exitcond.not = icmp eq i64 %.599, %.506
  br i1 %exitcond.not, label %B847, label %B684.if
}

define internal i32 @run_group.1(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, i64 %arg.table, i64 %arg.which, i64 %arg.group, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.28 = alloca ptr, align 8
  store ptr null, ptr %.28, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %0 = getelementptr i64, ptr %arg.layout, i64 %arg.table
  %.15 = getelementptr i8, ptr %0, i64 8
  %.16 = load i64, ptr %.15, align 8
  %.18 = getelementptr i8, ptr %0, i64 16
  %.19 = load i64, ptr %.18, align 8
  %.20 = mul nsw i64 %.19, %.16
  %.23 = getelementptr i8, ptr %0, i64 48
  %.24 = load i64, ptr %.23, align 8
  %.25 = mul nsw i64 %.20, %arg.group
  %1 = getelementptr i32, ptr %arg.idx, i64 %.24
  %.27 = getelementptr i32, ptr %1, i64 %.25
  store ptr null, ptr %.28, align 8
  %.32 = call i32 @gather.3(ptr nonnull %.28, ptr nonnull %excinfo.1, i64 %.20, ptr %.27, ptr %arg.Y, ptr %arg.local)
  switch i32 %.32, label %B0.if [
    i32 -2, label %B0.endif
    i32 0, label %B0.endif
  ]

B0.if:
  %.40 = icmp sgt i32 %.32, 0
  %.33 = load ptr, ptr %excinfo.1, align 8
  %.41 = select i1 %.40, ptr %.33, ptr undef
  store ptr %.41, ptr %excinfo, align 8
  br label %common.ret

common.ret:
  %common.ret.op = phi i32 [ 0, %B0.endif ], [ %.32, %B0.if ]
  ret i32 %common.ret.op

B0.endif:
  %.55 = getelementptr i8, ptr %0, i64 56
  %.56 = load i64, ptr %.55, align 8
  %.58 = getelementptr i8, ptr %0, i64 24
  %.59 = load i64, ptr %.58, align 8
  %.60 = mul i64 %.16, %arg.group
  %.61 = mul i64 %.60, %.59
  %.64 = getelementptr i8, ptr %0, i64 80
  %.65 = load i64, ptr %.64, align 8
  %2 = getelementptr double, ptr %arg.numbers, i64 %.56
  %.67 = getelementptr double, ptr %2, i64 %.61
  %.68 = getelementptr i64, ptr %arg.kernels, i64 %.65
  %.69 = load i64, ptr %.68, align 8
  %.70 = inttoptr i64 %.69 to ptr
  call void %.70(ptr %arg.local, ptr %.67, ptr %arg.out)
  store ptr null, ptr %retptr, align 8
  br label %common.ret
}

define internal i32 @scatter.2(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.count, ptr noalias %arg.places, ptr noalias %arg.source, ptr noalias %arg.target) {
entry:
  %.9534.not = icmp slt i64 %arg.count, 1
  br i1 %.9534.not, label %B96, label %B34.if

B96:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.035 = phi i64 [ %.108, %B34.if ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.035, 1
  %.134 = getelementptr i32, ptr %arg.places, i64 %.37.035
  %.135 = load i32, ptr %.134, align 4
  %.137 = sext i32 %.135 to i64
  %.138 = getelementptr double, ptr %arg.target, i64 %.137
  %.139 = load double, ptr %.138, align 8
  %.141 = getelementptr double, ptr %arg.source, i64 %.37.035
  %.142 = load double, ptr %.141, align 8
  %.143 = fadd contract double %.139, %.142
  store double %.143, ptr %.138, align 8
  %exitcond.not = icmp eq i64 %arg.count, %.108
  br i1 %exitcond.not, label %B96, label %B34.if
}

define internal i32 @gather.3(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.count, ptr noalias %arg.places, ptr noalias %arg.source, ptr noalias %arg.target) {
entry:
  %.9534.not = icmp slt i64 %arg.count, 1
  br i1 %.9534.not, label %B74, label %B34.if

B74:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.035 = phi i64 [ %.108, %B34.if ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.035, 1
  %.134 = getelementptr i32, ptr %arg.places, i64 %.37.035
  %.135 = load i32, ptr %.134, align 4
  %.137 = sext i32 %.135 to i64
  %.138 = getelementptr double, ptr %arg.source, i64 %.137
  %.139 = load double, ptr %.138, align 8
  %.141 = getelementptr double, ptr %arg.target, i64 %.37.035
  store double %.139, ptr %.141, align 8
  %exitcond.not = icmp eq i64 %arg.count, %.108
  br i1 %exitcond.not, label %B74, label %B34.if
}

define i64 @jacobian(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @jacobian.4(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8)
  ret i64 0
}

define internal i32 @jacobian.4(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.pos, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.J, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.340 = alloca ptr, align 8
  store ptr null, ptr %.340, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.496 = alloca ptr, align 8
  store ptr null, ptr %.496, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.534 = alloca ptr, align 8
  store ptr null, ptr %.534, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.32 = getelementptr i8, ptr %arg.layout, i64 16
  %.33 = load i64, ptr %.32, align 8
  %.34 = add nsw i64 %.33, 1
  %.36 = getelementptr i8, ptr %arg.layout, i64 24
  %.37 = load i64, ptr %.36, align 8
  %.38 = add nsw i64 %.34, %.37
  %.120124.not = icmp slt i64 %.38, 1
  br i1 %.120124.not, label %B106, label %B90.if.preheader

B90.if.preheader:
  %0 = shl nuw i64 %.38, 3
  call void @llvm.memset.p0.i64(ptr align 8 %arg.J, i8 0, i64 %0, i1 false)
  br label %B106

B106:
  %.167 = getelementptr i8, ptr %arg.layout, i64 32
  %.168 = load i64, ptr %.167, align 8
  %.249130.not = icmp slt i64 %.168, 1
  br i1 %.249130.not, label %B728, label %B160.if

B316:
  %.316 = getelementptr i8, ptr %3, i64 56
  %.317 = load i64, ptr %.316, align 8
  %.319 = getelementptr double, ptr %arg.numbers, i64 %.317
  %.323 = getelementptr i8, ptr %3, i64 72
  %.324 = load i64, ptr %.323, align 8
  %.332 = load i64, ptr %3, align 8
  %.334 = mul nsw i64 %.332, %.302
  %.338 = getelementptr i32, ptr %arg.pos, i64 %.324
  store ptr null, ptr %.340, align 8
  %.344 = call i32 @scatter.2(ptr nonnull %.340, ptr nonnull %excinfo.1, i64 %.334, ptr %.338, ptr %.319, ptr %arg.J)
  switch i32 %.344, label %B316.if [
    i32 -2, label %B729
    i32 0, label %B729
  ]

B508:
  %.369 = load i64, ptr %3, align 8
  %.449127.not = icmp slt i64 %.369, 1
  br i1 %.449127.not, label %B729, label %B566.if.lr.ph

B566.if.lr.ph:
  %.524 = getelementptr i8, ptr %3, i64 72
  br label %B566.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B728 ], [ %.538, %B568.endif.if ], [ %.344, %B316.if ], [ %.500, %B568.if ]
  ret i32 %common.ret.op

B728:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B729:
  %exitcond136.not = icmp eq i64 %.168, %.262
  br i1 %exitcond136.not, label %B728, label %B160.if

B160.if:
  %.192.0131 = phi i64 [ %.262, %B729 ], [ 0, %B106 ]
  %.262 = add nuw nsw i64 %.192.0131, 1
  %1 = mul nuw nsw i64 %.192.0131, 11
  %2 = add nuw nsw i64 %1, 8
  %3 = getelementptr i64, ptr %arg.layout, i64 %2
  %.295 = getelementptr i8, ptr %3, i64 40
  %.296 = load i64, ptr %.295, align 8
  %.300 = getelementptr i8, ptr %3, i64 8
  %.301 = load i64, ptr %.300, align 8
  %.302 = mul nsw i64 %.301, %.296
  %.309 = getelementptr i8, ptr %3, i64 80
  %.310 = load i64, ptr %.309, align 8
  %.311 = icmp eq i64 %.310, -1
  br i1 %.311, label %B316, label %B508

B316.if:
  %.352 = icmp sgt i32 %.344, 0
  %.345 = load ptr, ptr %excinfo.1, align 8
  %.353 = select i1 %.352, ptr %.345, ptr undef
  store ptr %.353, ptr %excinfo, align 8
  br label %common.ret

B566.if:
  %.393.0128 = phi i64 [ 0, %B566.if.lr.ph ], [ %.462, %B568.endif.endif ]
  %.462 = add nuw nsw i64 %.393.0128, 1
  store ptr null, ptr %.496, align 8
  %.500 = call i32 @run_group.5(ptr nonnull %.496, ptr nonnull %excinfo.2, ptr %arg.layout, i64 %2, i64 1, i64 %.393.0128, ptr %arg.kernels, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.local, ptr %arg.out)
  switch i32 %.500, label %B568.if [
    i32 -2, label %B568.endif
    i32 0, label %B568.endif
  ]

B568.if:
  %.508 = icmp sgt i32 %.500, 0
  %.501 = load ptr, ptr %excinfo.2, align 8
  %.509 = select i1 %.508, ptr %.501, ptr undef
  store ptr %.509, ptr %excinfo, align 8
  br label %common.ret

B568.endif:
  %.525 = load i64, ptr %.524, align 8
  %.527 = mul nsw i64 %.393.0128, %.302
  %4 = getelementptr i32, ptr %arg.pos, i64 %.525
  %.530 = getelementptr i32, ptr %4, i64 %.527
  store ptr null, ptr %.534, align 8
  %.538 = call i32 @scatter.2(ptr nonnull %.534, ptr nonnull %excinfo.3, i64 %.302, ptr %.530, ptr %arg.out, ptr %arg.J)
  switch i32 %.538, label %B568.endif.if [
    i32 -2, label %B568.endif.endif
    i32 0, label %B568.endif.endif
  ]

B568.endif.if:
  %.546 = icmp sgt i32 %.538, 0
  %.539 = load ptr, ptr %excinfo.3, align 8
  %.547 = select i1 %.546, ptr %.539, ptr undef
  store ptr %.547, ptr %excinfo, align 8
  br label %common.ret

B568.endif.endif:
  %exitcond.not = icmp eq i64 %.462, %.369
  br i1 %exitcond.not, label %B729, label %B566.if
}

define internal i32 @run_group.5(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, i64 %arg.table, i64 %arg.which, i64 %arg.group, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.28 = alloca ptr, align 8
  store ptr null, ptr %.28, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %0 = getelementptr i64, ptr %arg.layout, i64 %arg.table
  %.15 = getelementptr i8, ptr %0, i64 8
  %.16 = load i64, ptr %.15, align 8
  %.18 = getelementptr i8, ptr %0, i64 16
  %.19 = load i64, ptr %.18, align 8
  %.20 = mul nsw i64 %.19, %.16
  %.23 = getelementptr i8, ptr %0, i64 48
  %.24 = load i64, ptr %.23, align 8
  %.25 = mul nsw i64 %.20, %arg.group
  %1 = getelementptr i32, ptr %arg.idx, i64 %.24
  %.27 = getelementptr i32, ptr %1, i64 %.25
  store ptr null, ptr %.28, align 8
  %.32 = call i32 @gather.3(ptr nonnull %.28, ptr nonnull %excinfo.1, i64 %.20, ptr %.27, ptr %arg.Y, ptr %arg.local)
  switch i32 %.32, label %B0.if [
    i32 -2, label %B0.endif
    i32 0, label %B0.endif
  ]

B0.if:
  %.40 = icmp sgt i32 %.32, 0
  %.33 = load ptr, ptr %excinfo.1, align 8
  %.41 = select i1 %.40, ptr %.33, ptr undef
  store ptr %.41, ptr %excinfo, align 8
  br label %common.ret

common.ret:
  %common.ret.op = phi i32 [ 0, %B0.endif ], [ %.32, %B0.if ]
  ret i32 %common.ret.op

B0.endif:
  %.55 = getelementptr i8, ptr %0, i64 56
  %.56 = load i64, ptr %.55, align 8
  %.58 = getelementptr i8, ptr %0, i64 24
  %.59 = load i64, ptr %.58, align 8
  %.60 = mul i64 %.16, %arg.group
  %.61 = mul i64 %.60, %.59
  %.64 = getelementptr i8, ptr %0, i64 80
  %.65 = load i64, ptr %.64, align 8
  %2 = getelementptr double, ptr %arg.numbers, i64 %.56
  %.67 = getelementptr double, ptr %2, i64 %.61
  %3 = getelementptr i64, ptr %arg.kernels, i64 %.65
  %.68 = getelementptr i8, ptr %3, i64 8
  %.69 = load i64, ptr %.68, align 8
  %.70 = inttoptr i64 %.69 to ptr
  call void %.70(ptr %arg.local, ptr %.67, ptr %arg.out)
  store ptr null, ptr %retptr, align 8
  br label %common.ret
}

define i64 @drive(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @drive.6(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7)
  ret i64 0
}

define internal i32 @drive.6(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.312 = alloca ptr, align 8
  store ptr null, ptr %.312, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.30 = load i64, ptr %arg.layout, align 8
  %.32 = getelementptr double, ptr %arg.Y, i64 %.30
  %.37 = getelementptr i8, ptr %arg.layout, i64 40
  %.38 = load i64, ptr %.37, align 8
  %.120125.not = icmp slt i64 %.38, 1
  br i1 %.120125.not, label %B546, label %B110.if.lr.ph

B110.if.lr.ph:
  %.159 = getelementptr i8, ptr %arg.layout, i64 32
  %.475 = getelementptr i8, ptr %arg.layout, i64 8
  br label %B110.if

B110.loopexit:
  %exitcond130.not = icmp eq i64 %.133, %.38
  br i1 %exitcond130.not, label %B546, label %B110.if

B302.loopexit:
  %exitcond129.not = icmp eq i64 %.278, %.185
  br i1 %exitcond129.not, label %B110.loopexit, label %B302.if

B506:
  %.482 = getelementptr double, ptr %arg.out, i64 %.373.0120
  %.483 = load double, ptr %.482, align 8
  %.492 = getelementptr double, ptr %.32, i64 %.477
  store double %.483, ptr %.492, align 8
  br label %B540

B540:
  %exitcond.not = icmp eq i64 %.177, %.442
  br i1 %exitcond.not, label %B302.loopexit, label %B456.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B546 ], [ %.316, %B304.if ]
  ret i32 %common.ret.op

B546:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B110.if:
  %.62.0126 = phi i64 [ 0, %B110.if.lr.ph ], [ %.133, %B110.loopexit ]
  %.133 = add nuw nsw i64 %.62.0126, 1
  %.160 = load i64, ptr %.159, align 8
  %.161 = add nsw i64 %.160, %.62.0126
  %.162 = mul nsw i64 %.161, 11
  %.163 = add nsw i64 %.162, 8
  %0 = getelementptr i64, ptr %arg.layout, i64 %.162
  %.170 = getelementptr i8, ptr %0, i64 96
  %.171 = load i64, ptr %.170, align 8
  %.175 = getelementptr i8, ptr %0, i64 72
  %.176 = load i64, ptr %.175, align 8
  %.177 = mul i64 %.176, %.171
  %.184 = getelementptr i64, ptr %arg.layout, i64 %.163
  %.185 = load i64, ptr %.184, align 8
  %.265122.not = icmp slt i64 %.185, 1
  br i1 %.265122.not, label %B110.loopexit, label %B302.if.lr.ph

B302.if.lr.ph:
  %.339 = getelementptr i8, ptr %0, i64 128
  %.429119.not = icmp slt i64 %.177, 1
  br label %B302.if

B302.if:
  %.209.0123 = phi i64 [ 0, %B302.if.lr.ph ], [ %.278, %B302.loopexit ]
  %.278 = add nuw nsw i64 %.209.0123, 1
  store ptr null, ptr %.312, align 8
  %.316 = call i32 @run_group.1(ptr nonnull %.312, ptr nonnull %excinfo.1, ptr nonnull %arg.layout, i64 %.163, i64 0, i64 %.209.0123, ptr %arg.kernels, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.local, ptr %arg.out)
  switch i32 %.316, label %B304.if [
    i32 -2, label %B304.endif
    i32 0, label %B304.endif
  ]

B304.if:
  %.324 = icmp sgt i32 %.316, 0
  %.317 = load ptr, ptr %excinfo.1, align 8
  %.325 = select i1 %.324, ptr %.317, ptr undef
  store ptr %.325, ptr %excinfo, align 8
  br label %common.ret

B304.endif:
  %.340 = load i64, ptr %.339, align 8
  %.342 = mul nsw i64 %.209.0123, %.177
  %1 = getelementptr i32, ptr %arg.rows, i64 %.340
  %.345 = getelementptr i32, ptr %1, i64 %.342
  br i1 %.429119.not, label %B302.loopexit, label %B456.if.lr.ph

B456.if.lr.ph:
  %.476 = load i64, ptr %.475, align 8
  br label %B456.if

B456.if:
  %.373.0120 = phi i64 [ 0, %B456.if.lr.ph ], [ %.442, %B540 ]
  %.442 = add nuw nsw i64 %.373.0120, 1
  %.472 = getelementptr i32, ptr %.345, i64 %.373.0120
  %.473 = load i32, ptr %.472, align 4
  %.477 = sext i32 %.473 to i64
  %.478 = icmp sgt i64 %.476, %.477
  br i1 %.478, label %B506, label %B540
}

define i64 @drive_rates(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @drive_rates.7(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8)
  ret i64 0
}

define internal i32 @drive_rates.7(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.rates, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.436 = alloca ptr, align 8
  store ptr null, ptr %.436, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.32 = getelementptr i8, ptr %arg.layout, i64 8
  %.33 = load i64, ptr %.32, align 8
  %.116149 = icmp sgt i64 %.33, -1
  br i1 %.116149, label %B62.if.preheader, label %B78

B62.if.preheader:
  %storemerge = add nuw i64 %.33, 1
  %0 = add nuw i64 %.33, 2
  %smin = call i64 @llvm.smin.i64(i64 %storemerge, i64 1)
  %1 = sub i64 %0, %smin
  %2 = shl nuw i64 %1, 3
  call void @llvm.memset.p0.i64(ptr align 8 %arg.rates, i8 0, i64 %2, i1 false)
  br label %B78

B78:
  %.163 = getelementptr i8, ptr %arg.layout, i64 40
  %.164 = load i64, ptr %.163, align 8
  %.244158.not = icmp slt i64 %.164, 1
  br i1 %.244158.not, label %B520, label %B130.if.lr.ph

B130.if.lr.ph:
  %.283 = getelementptr i8, ptr %arg.layout, i64 32
  br label %B130.if

B130.loopexit:
  %exitcond163.not = icmp eq i64 %.257, %.164
  br i1 %exitcond163.not, label %B520, label %B130.if

B322.loopexit:
  %exitcond162.not = icmp eq i64 %.402, %.309
  br i1 %exitcond162.not, label %B130.loopexit, label %B322.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B520 ], [ %.440, %B324.if ]
  ret i32 %common.ret.op

B520:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B130.if:
  %.188.0159 = phi i64 [ 0, %B130.if.lr.ph ], [ %.257, %B130.loopexit ]
  %.257 = add nuw nsw i64 %.188.0159, 1
  %.284 = load i64, ptr %.283, align 8
  %.285 = add nsw i64 %.284, %.188.0159
  %.286 = mul nsw i64 %.285, 11
  %.287 = add nsw i64 %.286, 8
  %3 = getelementptr i64, ptr %arg.layout, i64 %.286
  %.294 = getelementptr i8, ptr %3, i64 96
  %.295 = load i64, ptr %.294, align 8
  %.299 = getelementptr i8, ptr %3, i64 72
  %.300 = load i64, ptr %.299, align 8
  %.301 = mul i64 %.300, %.295
  %.308 = getelementptr i64, ptr %arg.layout, i64 %.287
  %.309 = load i64, ptr %.308, align 8
  %.389155.not = icmp slt i64 %.309, 1
  br i1 %.389155.not, label %B130.loopexit, label %B322.if.lr.ph

B322.if.lr.ph:
  %.463 = getelementptr i8, ptr %3, i64 128
  %.553152.not = icmp slt i64 %.301, 1
  br label %B322.if

B322.if:
  %.333.0156 = phi i64 [ 0, %B322.if.lr.ph ], [ %.402, %B322.loopexit ]
  %.402 = add nuw nsw i64 %.333.0156, 1
  store ptr null, ptr %.436, align 8
  %.440 = call i32 @run_group.5(ptr nonnull %.436, ptr nonnull %excinfo.1, ptr %arg.layout, i64 %.287, i64 1, i64 %.333.0156, ptr %arg.kernels, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.local, ptr %arg.out)
  switch i32 %.440, label %B324.if [
    i32 -2, label %B324.endif
    i32 0, label %B324.endif
  ]

B324.if:
  %.448 = icmp sgt i32 %.440, 0
  %.441 = load ptr, ptr %excinfo.1, align 8
  %.449 = select i1 %.448, ptr %.441, ptr undef
  store ptr %.449, ptr %excinfo, align 8
  br label %common.ret

B324.endif:
  %.464 = load i64, ptr %.463, align 8
  %.466 = mul nsw i64 %.333.0156, %.301
  %4 = getelementptr i32, ptr %arg.rows, i64 %.464
  %.469 = getelementptr i32, ptr %4, i64 %.466
  br i1 %.553152.not, label %B322.loopexit, label %B476.if

B476.if:
  %.497.0153 = phi i64 [ %.566, %B476.if ], [ 0, %B324.endif ]
  %.566 = add nuw nsw i64 %.497.0153, 1
  %.592 = getelementptr double, ptr %arg.out, i64 %.497.0153
  %.593 = load double, ptr %.592, align 8
  %.595 = getelementptr i32, ptr %.469, i64 %.497.0153
  %.596 = load i32, ptr %.595, align 4
  %.598 = sext i32 %.596 to i64
  %.599 = getelementptr double, ptr %arg.rates, i64 %.598
  store double %.593, ptr %.599, align 8
  %exitcond.not = icmp eq i64 %.301, %.566
  br i1 %exitcond.not, label %B322.loopexit, label %B476.if
}

define i64 @pair_up(i64 %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @pair_up.8(ptr nonnull %r, ptr nonnull %e, i64 %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6)
  ret i64 0
}

define internal i32 @pair_up.8(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.start, ptr noalias %arg.columns, ptr noalias %arg.weak, ptr noalias %arg.partner, ptr noalias %arg.common, ptr noalias %arg.seen) noinline {
entry:
  %.107242.not = icmp slt i64 %arg.n, 1
  br i1 %.107242.not, label %B90.preheader, label %B34.if.preheader

B34.if.preheader:
  %0 = shl nuw i64 %arg.n, 2
  call void @llvm.memset.p0.i64(ptr align 4 %arg.partner, i8 -1, i64 %0, i1 false)
  %1 = shl nuw i64 %arg.n, 2
  call void @llvm.memset.p0.i64(ptr align 4 %arg.common, i8 0, i64 %1, i1 false)
  br label %B90.preheader

B90.preheader:
  %.241260.not = icmp slt i64 %arg.n, 1
  br i1 %.241260.not, label %B692, label %B92.if

B122:
  %.297 = getelementptr i32, ptr %arg.start, i64 %.184.0261
  %.298 = load i32, ptr %.297, align 4
  %.302 = getelementptr i8, ptr %.297, i64 4
  %.303 = load i32, ptr %.302, align 4
  %.340 = sub i32 %.303, %.298
  %.383249.not = icmp slt i32 %.340, 1
  br i1 %.383249.not, label %B442, label %B188.if.lr.ph

B188.if.lr.ph:
  %.594 = getelementptr i32, ptr %arg.weak, i64 %.184.0261
  br label %B188.if

B188.loopexit:
  %count.2.2.lcssa = phi i64 [ %count.5.1252, %B188.if ], [ %count.3.3, %B438 ]
  %.383 = icmp sgt i32 %.330.0251, 1
  br i1 %.383, label %B188.if, label %B442

B302:
  %.579 = getelementptr i32, ptr %arg.partner, i64 %.570
  %.580 = load i32, ptr %.579, align 4
  %.582 = icmp slt i32 %.580, 0
  br i1 %.582, label %B326, label %B438

B326:
  %.590 = getelementptr i32, ptr %arg.weak, i64 %.570
  %.591 = load i32, ptr %.590, align 4
  %.595 = load i32, ptr %.594, align 4
  %.596 = icmp eq i32 %.591, %.595
  br i1 %.596, label %B362, label %B438

B362:
  %.607 = getelementptr i32, ptr %arg.common, i64 %.570
  %.608 = load i32, ptr %.607, align 4
  %.610 = icmp eq i32 %.608, 0
  br i1 %.610, label %B386, label %B406

B386:
  %.615 = getelementptr i32, ptr %arg.seen, i64 %count.2.2248
  store i32 %.564, ptr %.615, align 4
  %.618 = add nsw i64 %count.2.2248, 1
  br label %B406

B406:
  %count.4.3 = phi i64 [ %.618, %B386 ], [ %count.2.2248, %B362 ]
  %.637 = add i32 %.608, 1
  store i32 %.637, ptr %.607, align 4
  br label %B438

B438:
  %count.3.3 = phi i64 [ %count.4.3, %B406 ], [ %count.2.2248, %B326 ], [ %count.2.2248, %B302 ], [ %count.2.2248, %B270.if ]
  %.519 = icmp sgt i32 %.466.0247, 1
  br i1 %.519, label %B270.if, label %B188.loopexit

B442:
  %count.5.1.lcssa = phi i64 [ 0, %B122 ], [ %count.2.2.lcssa, %B188.loopexit ]
  %.761254.not = icmp slt i64 %count.5.1.lcssa, 1
  br i1 %.761254.not, label %B656, label %B482.if.lr.ph

B482.if.lr.ph:
  %.824 = sext i32 %.303 to i64
  %.825 = sext i32 %.298 to i64
  br label %B482.if

B656:
  %best.2.1.lcssa = phi i64 [ -1, %B442 ], [ %best.3.2, %B482.if ]
  %.908 = icmp sgt i64 %best.2.1.lcssa, -1
  br i1 %.908, label %B668, label %B693

B668:
  %.913 = trunc nuw nsw i64 %best.2.1.lcssa to i32
  store i32 %.913, ptr %.284, align 4
  %.919 = trunc i64 %.184.0261 to i32
  %.920 = getelementptr i32, ptr %arg.partner, i64 %best.2.1.lcssa
  store i32 %.919, ptr %.920, align 4
  br label %B693

B692:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B693:
  %exitcond263.not = icmp eq i64 %arg.n, %.254
  br i1 %exitcond263.not, label %B692, label %B92.if

B92.if:
  %.184.0261 = phi i64 [ %.254, %B693 ], [ 0, %B90.preheader ]
  %.254 = add nuw nsw i64 %.184.0261, 1
  %.284 = getelementptr i32, ptr %arg.partner, i64 %.184.0261
  %.285 = load i32, ptr %.284, align 4
  %.287 = icmp sgt i32 %.285, -1
  br i1 %.287, label %B693, label %B122

B188.if:
  %count.5.1252 = phi i64 [ 0, %B188.if.lr.ph ], [ %count.2.2.lcssa, %B188.loopexit ]
  %.330.0251 = phi i32 [ %.340, %B188.if.lr.ph ], [ %.392, %B188.loopexit ]
  %.327.0250 = phi i32 [ %.298, %B188.if.lr.ph ], [ %.396, %B188.loopexit ]
  %.392 = add nsw i32 %.330.0251, -1
  %.396 = add i32 %.327.0250, 1
  %2 = sext i32 %.327.0250 to i64
  %.429 = getelementptr i32, ptr %arg.columns, i64 %2
  %.430 = load i32, ptr %.429, align 4
  %.432 = sext i32 %.430 to i64
  %.433 = getelementptr i32, ptr %arg.start, i64 %.432
  %.434 = load i32, ptr %.433, align 4
  %.438 = getelementptr i8, ptr %.433, i64 4
  %.439 = load i32, ptr %.438, align 4
  %.476 = sub i32 %.439, %.434
  %.519245.not = icmp slt i32 %.476, 1
  br i1 %.519245.not, label %B188.loopexit, label %B270.if

B270.if:
  %count.2.2248 = phi i64 [ %count.3.3, %B438 ], [ %count.5.1252, %B188.if ]
  %.466.0247 = phi i32 [ %.528, %B438 ], [ %.476, %B188.if ]
  %.463.0246 = phi i32 [ %.532, %B438 ], [ %.434, %B188.if ]
  %.528 = add nsw i32 %.466.0247, -1
  %.532 = add i32 %.463.0246, 1
  %3 = sext i32 %.463.0246 to i64
  %.563 = getelementptr i32, ptr %arg.columns, i64 %3
  %.564 = load i32, ptr %.563, align 4
  %.570 = sext i32 %.564 to i64
  %.571 = icmp slt i64 %.184.0261, %.570
  br i1 %.571, label %B302, label %B438

B482.if:
  %most.2.1258 = phi double [ 0.000000e+00, %B482.if.lr.ph ], [ %most.3.2, %B482.if ]
  %best.2.1257 = phi i64 [ -1, %B482.if.lr.ph ], [ %best.3.2, %B482.if ]
  %.705.0255 = phi i64 [ 0, %B482.if.lr.ph ], [ %.774, %B482.if ]
  %.774 = add nuw nsw i64 %.705.0255, 1
  %.810 = getelementptr i32, ptr %arg.seen, i64 %.705.0255
  %.811 = load i32, ptr %.810, align 4
  %.828 = sext i32 %.811 to i64
  %4 = getelementptr i32, ptr %arg.start, i64 %.828
  %.831 = getelementptr i8, ptr %4, i64 4
  %.832 = load i32, ptr %.831, align 4
  %.833 = sext i32 %.832 to i64
  %.839 = load i32, ptr %4, align 4
  %.840 = sext i32 %.839 to i64
  %.845 = getelementptr i32, ptr %arg.common, i64 %.828
  %.846 = load i32, ptr %.845, align 4
  %.847 = sext i32 %.846 to i64
  %5 = add nsw i64 %.824, %.833
  %6 = add nsw i64 %.825, %.840
  %7 = add nsw i64 %6, %.847
  %.848 = sub nsw i64 %5, %7
  %.855 = sitofp i32 %.846 to double
  %.856 = sitofp i64 %.848 to double
  %.860 = fdiv contract double %.855, %.856
  %.866 = fcmp contract ogt double %.860, %most.2.1258
  %best.3.2 = select i1 %.866, i64 %.828, i64 %best.2.1257
  %most.3.2 = select i1 %.866, double %.860, double %most.2.1258
  store i32 0, ptr %.845, align 4
  %exitcond.not = icmp eq i64 %.774, %count.5.1.lcssa
  br i1 %exitcond.not, label %B656, label %B482.if
}

define i64 @elimination_order(i64 %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, i64 %a6, ptr %a7, ptr %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, ptr %a14, ptr %a15, ptr %a16) {
  %r = alloca i64, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @elimination_order.9(ptr nonnull %r, ptr nonnull %e, i64 %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, i64 %a6, ptr %a7, ptr %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, ptr %a14, ptr %a15, ptr %a16)
  %v = load i64, ptr %r, align 8
  ret i64 %v
}

define internal i32 @elimination_order.9(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.start, ptr noalias %arg.members, ptr noalias %arg.first, ptr noalias %arg.awaiting, ptr noalias %arg.waits, i64 %arg.capacity, ptr noalias %arg.order, ptr noalias %arg.at, ptr noalias %arg.count, ptr noalias %arg.room, ptr noalias %arg.pool, ptr noalias %arg.degree, ptr noalias %arg.head, ptr noalias %arg.after, ptr noalias %arg.before, ptr noalias %arg.mark) noinline {
entry:
  %.511 = alloca ptr, align 8
  store ptr null, ptr %.511, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.733 = alloca ptr, align 8
  store ptr null, ptr %.733, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.1066 = alloca i64, align 8
  store i64 0, ptr %.1066, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.1164 = alloca ptr, align 8
  store ptr null, ptr %.1164, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.1228 = alloca ptr, align 8
  store ptr null, ptr %.1228, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.1262 = alloca i64, align 8
  store i64 0, ptr %.1262, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.1503 = alloca ptr, align 8
  store ptr null, ptr %.1503, align 8
  %excinfo.7 = alloca ptr, align 8
  store ptr null, ptr %excinfo.7, align 8
  %.1537 = alloca i64, align 8
  store i64 0, ptr %.1537, align 8
  %excinfo.8 = alloca ptr, align 8
  store ptr null, ptr %excinfo.8, align 8
  %.56 = shl nsw i64 %arg.n, 1
  %.58 = getelementptr i32, ptr %arg.start, i64 %.56
  %.59 = load i32, ptr %.58, align 4
  %.102 = icmp sgt i64 %arg.n, 0
  %storemerge = select i1 %.102, i64 %.56, i64 0
  %.146427 = icmp sgt i64 %storemerge, 0
  br i1 %.146427, label %B62.if.preheader, label %B166

B62.if.preheader:
  %0 = shl nuw i64 %storemerge, 2
  call void @llvm.memset.p0.i64(ptr align 4 %arg.head, i8 -1, i64 %0, i1 false)
  %1 = shl nuw i64 %storemerge, 2
  call void @llvm.memset.p0.i64(ptr align 4 %arg.mark, i8 -1, i64 %1, i1 false)
  %2 = shl nuw i64 %storemerge, 2
  call void @llvm.memcpy.p0.p0.i64(ptr align 4 %arg.at, ptr align 4 %arg.start, i64 %2, i1 false)
  br label %B62.if

B166:
  %.303430.not = icmp slt i32 %.59, 1
  br i1 %.303430.not, label %B224, label %B196.if.preheader

B196.if.preheader:
  %3 = add nsw i32 %.59, -1
  %4 = zext i32 %3 to i64
  %5 = shl nuw nsw i64 %4, 2
  %6 = add nuw nsw i64 %5, 4
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 4 dereferenceable(1) %arg.pool, ptr nonnull align 4 dereferenceable(1) %arg.members, i64 %6, i1 false)
  br label %B224

B224:
  br i1 %.102, label %B254.if.lr.ph, label %B384

B254.if.lr.ph:
  %7 = getelementptr i32, ptr %arg.count, i64 %arg.n
  br label %B254.if

B344:
  store ptr null, ptr %.511, align 8
  %.515 = call i32 @enlist.10(ptr nonnull %.511, ptr nonnull %excinfo.1, i64 %.476, ptr %arg.degree, ptr %arg.head, ptr %arg.after, ptr %arg.before)
  switch i32 %.515, label %B344.if [
    i32 -2, label %B382
    i32 0, label %B382
  ]

B382:
  %exitcond479.not = icmp eq i64 %arg.n, %.449
  br i1 %exitcond479.not, label %B384, label %B254.if

B384:
  %.636451.not = icmp slt i64 %arg.n, 1
  br i1 %.636451.not, label %B1226, label %B420.if.lr.ph

B420.if.lr.ph:
  %.546 = sext i32 %.59 to i64
  %8 = getelementptr i32, ptr %arg.count, i64 %arg.n
  %9 = getelementptr i32, ptr %arg.count, i64 %arg.n
  br label %B420.if

B418.loopexit:
  %least.5.1.lcssa = phi i64 [ %least.8.2.lcssa, %B1000 ], [ %least.10.2, %B1220 ]
  %exitcond483.not = icmp eq i64 %arg.n, %.649
  br i1 %exitcond483.not, label %B1226, label %B420.if

B448:
  %least.11.1 = phi i64 [ %.695, %B448 ], [ %least.4.0455, %B420.if ]
  %.695 = add nsw i64 %least.11.1, 1
  %.701 = getelementptr i32, ptr %arg.head, i64 %.695
  %.702 = load i32, ptr %.701, align 4
  %.704 = icmp slt i32 %.702, 0
  br i1 %.704, label %B448, label %B482

B482:
  %least.7.2 = phi i64 [ %least.4.0455, %B420.if ], [ %.695, %B448 ]
  %.720 = getelementptr i32, ptr %arg.head, i64 %least.7.2
  %.721 = load i32, ptr %.720, align 4
  store ptr null, ptr %.733, align 8
  %.737 = call i32 @delist.11(ptr nonnull %.733, ptr nonnull %excinfo.2, i32 %.721, ptr %arg.degree, ptr %arg.head, ptr %arg.after, ptr %arg.before)
  switch i32 %.737, label %B482.if [
    i32 -2, label %B482.endif
    i32 0, label %B482.endif
  ]

B576.loopexit:
  %free.2.2.lcssa = phi i64 [ %free.3.1444, %B576.if ], [ %.1080, %B996 ]
  %least.8.2.lcssa = phi i64 [ %least.6.1445, %B576.if ], [ %least.9.3, %B996 ]
  br i1 %exitcond482.not, label %B1000, label %B576.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B772 ], [ 0, %B1226 ], [ %.1541, %B1138.endif.if ], [ %.1266, %B914.endif.if ], [ %.737, %B482.if ], [ %.1507, %B1138.if ], [ %.1232, %B914.if ], [ %.515, %B344.if ], [ %.1168, %B806.if ], [ %.1070, %B662.if ]
  ret i32 %common.ret.op

B772:
  store i64 -1, ptr %retptr, align 8
  br label %common.ret

B782:
  %.1153 = getelementptr i32, ptr %arg.waits, i64 %.1054
  %.1154 = load i32, ptr %.1153, align 4
  %.1156 = icmp eq i32 %.1154, 0
  br i1 %.1156, label %B806, label %B996.critedge

B806:
  store ptr null, ptr %.1164, align 8
  %.1168 = call i32 @delist.11(ptr nonnull %.1164, ptr nonnull %excinfo.4, i32 %.1045, ptr %arg.degree, ptr %arg.head, ptr %arg.after, ptr %arg.before)
  switch i32 %.1168, label %B806.if [
    i32 -2, label %B844
    i32 0, label %B844
  ]

B844:
  %.1196 = getelementptr i32, ptr %arg.count, i64 %.1054
  %.1197 = load i32, ptr %.1196, align 4
  %.1203 = getelementptr i32, ptr %9, i64 %.1054
  %.1204 = load i32, ptr %.1203, align 4
  %.1207 = add i32 %.1204, %.1197
  %.1212 = getelementptr i32, ptr %arg.degree, i64 %.1054
  store i32 %.1207, ptr %.1212, align 4
  store ptr null, ptr %.1228, align 8
  %.1232 = call i32 @enlist.12(ptr nonnull %.1228, ptr nonnull %excinfo.5, i32 %.1045, ptr %arg.degree, ptr %arg.head, ptr %arg.after, ptr %arg.before)
  switch i32 %.1232, label %B914.if [
    i32 -2, label %B914.endif
    i32 0, label %B914.endif
  ]

B996.critedge:
  %.1196.c = getelementptr i32, ptr %arg.count, i64 %.1054
  %.1197.c = load i32, ptr %.1196.c, align 4
  %.1203.c = getelementptr i32, ptr %8, i64 %.1054
  %.1204.c = load i32, ptr %.1203.c, align 4
  %.1207.c = add i32 %.1204.c, %.1197.c
  %.1212.c = getelementptr i32, ptr %arg.degree, i64 %.1054
  store i32 %.1207.c, ptr %.1212.c, align 4
  br label %B996

B996:
  %least.9.3 = phi i64 [ %.1276, %B914.endif.endif ], [ %least.8.2440, %B996.critedge ]
  %exitcond481.not = icmp eq i64 %indvars.iv.next, %wide.trip.count
  br i1 %exitcond481.not, label %B576.loopexit, label %B660.if

B1000:
  %.1337 = sext i32 %.721 to i64
  %.1338 = getelementptr i32, ptr %arg.first, i64 %.1337
  %.1339 = load i32, ptr %.1338, align 4
  %.1346 = getelementptr i8, ptr %.1338, i64 4
  %.1347 = load i32, ptr %.1346, align 4
  %.1384 = sub i32 %.1347, %.1339
  %.1427446.not = icmp slt i32 %.1384, 1
  br i1 %.1427446.not, label %B418.loopexit, label %B1062.if

B1138:
  store ptr null, ptr %.1503, align 8
  %.1507 = call i32 @enlist.12(ptr nonnull %.1503, ptr nonnull %excinfo.7, i32 %.1472, ptr %arg.degree, ptr %arg.head, ptr %arg.after, ptr %arg.before)
  switch i32 %.1507, label %B1138.if [
    i32 -2, label %B1138.endif
    i32 0, label %B1138.endif
  ]

B1220:
  %least.10.2 = phi i64 [ %.1551, %B1138.endif.endif ], [ %least.5.1449, %B1062.if ]
  %.1427 = icmp sgt i32 %.1374.0448, 1
  br i1 %.1427, label %B1062.if, label %B418.loopexit

B1226:
  store i64 0, ptr %retptr, align 8
  br label %common.ret

B62.if:
  %.88.0428 = phi i64 [ %.159, %B62.if ], [ 0, %B62.if.preheader ]
  %.159 = add nuw nsw i64 %.88.0428, 1
  %.185 = getelementptr i32, ptr %arg.start, i64 %.88.0428
  %.186 = load i32, ptr %.185, align 4
  %.192 = getelementptr i8, ptr %.185, i64 4
  %.193 = load i32, ptr %.192, align 4
  %.199 = sub i32 %.193, %.186
  %.202 = getelementptr i32, ptr %arg.count, i64 %.88.0428
  store i32 %.199, ptr %.202, align 4
  %.206 = getelementptr i32, ptr %arg.room, i64 %.88.0428
  store i32 %.199, ptr %.206, align 4
  %exitcond.not = icmp eq i64 %.159, %storemerge
  br i1 %exitcond.not, label %B166, label %B62.if

B254.if:
  %.380.0434 = phi i64 [ 0, %B254.if.lr.ph ], [ %.449, %B382 ]
  %.449 = add nuw nsw i64 %.380.0434, 1
  %10 = xor i64 %.380.0434, -1
  %.476 = add nsw i64 %arg.n, %10
  %.482 = getelementptr i32, ptr %arg.count, i64 %.476
  %.483 = load i32, ptr %.482, align 4
  %.488 = getelementptr i32, ptr %7, i64 %.476
  %.489 = load i32, ptr %.488, align 4
  %.492 = add i32 %.489, %.483
  %.496 = getelementptr i32, ptr %arg.degree, i64 %.476
  store i32 %.492, ptr %.496, align 4
  %.500 = getelementptr i32, ptr %arg.waits, i64 %.476
  %.501 = load i32, ptr %.500, align 4
  %.503 = icmp eq i32 %.501, 0
  br i1 %.503, label %B344, label %B382

B344.if:
  %.523 = icmp sgt i32 %.515, 0
  %.516 = load ptr, ptr %excinfo.1, align 8
  %.524 = select i1 %.523, ptr %.516, ptr undef
  store ptr %.524, ptr %excinfo, align 8
  br label %common.ret

B420.if:
  %least.4.0455 = phi i64 [ 0, %B420.if.lr.ph ], [ %least.5.1.lcssa, %B418.loopexit ]
  %free.4.0454 = phi i64 [ %.546, %B420.if.lr.ph ], [ %free.2.2.lcssa, %B418.loopexit ]
  %.579.0452 = phi i64 [ 0, %B420.if.lr.ph ], [ %.649, %B418.loopexit ]
  %.649 = add nuw nsw i64 %.579.0452, 1
  %.687 = getelementptr i32, ptr %arg.head, i64 %least.4.0455
  %.688 = load i32, ptr %.687, align 4
  %.692 = icmp slt i32 %.688, 0
  br i1 %.692, label %B448, label %B482

B482.if:
  %.745 = icmp sgt i32 %.737, 0
  %.738 = load ptr, ptr %excinfo.2, align 8
  %.746 = select i1 %.745, ptr %.738, ptr undef
  store ptr %.746, ptr %excinfo, align 8
  br label %common.ret

B482.endif:
  %.760 = getelementptr i32, ptr %arg.order, i64 %.579.0452
  store i32 %.721, ptr %.760, align 4
  %.900 = sext i32 %.721 to i64
  br label %B576.if

B576.if:
  %least.6.1445 = phi i64 [ %least.7.2, %B482.endif ], [ %least.8.2.lcssa, %B576.loopexit ]
  %free.3.1444 = phi i64 [ %free.4.0454, %B482.endif ], [ %free.2.2.lcssa, %B576.loopexit ]
  %exitcond482.not = phi i1 [ false, %B482.endif ], [ true, %B576.loopexit ]
  %.787.0442 = phi i64 [ 0, %B482.endif ], [ 1, %B576.loopexit ]
  %.898 = mul nuw nsw i64 %.787.0442, %arg.n
  %.901 = add nsw i64 %.898, %.900
  %.903 = xor i64 %.787.0442, 1
  %.905 = mul nuw nsw i64 %.903, %arg.n
  %.908 = add nsw i64 %.905, %.900
  %.917 = getelementptr i32, ptr %arg.count, i64 %.908
  %.918 = load i32, ptr %.917, align 4
  %.998436.not = icmp slt i32 %.918, 1
  br i1 %.998436.not, label %B576.loopexit, label %B660.if.lr.ph

B660.if.lr.ph:
  %.1038 = getelementptr i32, ptr %arg.at, i64 %.908
  %wide.trip.count = zext nneg i32 %.918 to i64
  br label %B660.if

B660.if:
  %indvars.iv = phi i64 [ 0, %B660.if.lr.ph ], [ %indvars.iv.next, %B996 ]
  %least.8.2440 = phi i64 [ %least.6.1445, %B660.if.lr.ph ], [ %least.9.3, %B996 ]
  %free.2.2439 = phi i64 [ %free.3.1444, %B660.if.lr.ph ], [ %.1080, %B996 ]
  %indvars.iv.next = add nuw nsw i64 %indvars.iv, 1
  %.1039 = load i32, ptr %.1038, align 4
  %.1040 = sext i32 %.1039 to i64
  %11 = getelementptr i32, ptr %arg.pool, i64 %indvars.iv
  %.1044 = getelementptr i32, ptr %11, i64 %.1040
  %.1045 = load i32, ptr %.1044, align 4
  %.1054 = sext i32 %.1045 to i64
  %.1055 = add nsw i64 %.898, %.1054
  store i64 0, ptr %.1066, align 8
  %.1070 = call i32 @merge.13(ptr nonnull %.1066, ptr nonnull %excinfo.3, i64 %.1055, i64 %.901, i32 %.1045, i32 %.721, i64 %free.2.2439, i64 %arg.capacity, ptr %arg.at, ptr %arg.count, ptr %arg.room, ptr %arg.pool, ptr %arg.mark)
  %.1080 = load i64, ptr %.1066, align 8
  switch i32 %.1070, label %B662.if [
    i32 -2, label %B662.endif
    i32 0, label %B662.endif
  ]

B662.if:
  %.1078 = icmp sgt i32 %.1070, 0
  %.1071 = load ptr, ptr %excinfo.3, align 8
  %.1079 = select i1 %.1078, ptr %.1071, ptr undef
  store ptr %.1079, ptr %excinfo, align 8
  br label %common.ret

B662.endif:
  %.1096 = icmp slt i64 %.1080, 0
  br i1 %.1096, label %B772, label %B782

B806.if:
  %.1176 = icmp sgt i32 %.1168, 0
  %.1169 = load ptr, ptr %excinfo.4, align 8
  %.1177 = select i1 %.1176, ptr %.1169, ptr undef
  store ptr %.1177, ptr %excinfo, align 8
  br label %common.ret

B914.if:
  %.1240 = icmp sgt i32 %.1232, 0
  %.1233 = load ptr, ptr %excinfo.5, align 8
  %.1241 = select i1 %.1240, ptr %.1233, ptr undef
  store ptr %.1241, ptr %excinfo, align 8
  br label %common.ret

B914.endif:
  %.1256 = load i32, ptr %.1212, align 4
  store i64 0, ptr %.1262, align 8
  %.1266 = call i32 @numba.14(ptr nonnull %.1262, ptr nonnull %excinfo.6, i64 %least.8.2440, i32 %.1256)
  switch i32 %.1266, label %B914.endif.if [
    i32 -2, label %B914.endif.endif
    i32 0, label %B914.endif.endif
  ]

B914.endif.if:
  %.1274 = icmp sgt i32 %.1266, 0
  %.1267 = load ptr, ptr %excinfo.6, align 8
  %.1275 = select i1 %.1274, ptr %.1267, ptr undef
  store ptr %.1275, ptr %excinfo, align 8
  br label %common.ret

B914.endif.endif:
  %.1276 = load i64, ptr %.1262, align 8
  br label %B996

B1062.if:
  %least.5.1449 = phi i64 [ %least.10.2, %B1220 ], [ %least.8.2.lcssa, %B1000 ]
  %.1374.0448 = phi i32 [ %.1436, %B1220 ], [ %.1384, %B1000 ]
  %.1371.0447 = phi i32 [ %.1440, %B1220 ], [ %.1339, %B1000 ]
  %.1436 = add nsw i32 %.1374.0448, -1
  %.1440 = add i32 %.1371.0447, 1
  %12 = sext i32 %.1371.0447 to i64
  %.1471 = getelementptr i32, ptr %arg.awaiting, i64 %12
  %.1472 = load i32, ptr %.1471, align 4
  %.1478 = sext i32 %.1472 to i64
  %.1479 = getelementptr i32, ptr %arg.waits, i64 %.1478
  %.1480 = load i32, ptr %.1479, align 4
  %.1482 = add i32 %.1480, -1
  store i32 %.1482, ptr %.1479, align 4
  %.1495 = icmp eq i32 %.1482, 0
  br i1 %.1495, label %B1138, label %B1220

B1138.if:
  %.1515 = icmp sgt i32 %.1507, 0
  %.1508 = load ptr, ptr %excinfo.7, align 8
  %.1516 = select i1 %.1515, ptr %.1508, ptr undef
  store ptr %.1516, ptr %excinfo, align 8
  br label %common.ret

B1138.endif:
  %.1530 = getelementptr i32, ptr %arg.degree, i64 %.1478
  %.1531 = load i32, ptr %.1530, align 4
  store i64 0, ptr %.1537, align 8
  %.1541 = call i32 @numba.14(ptr nonnull %.1537, ptr nonnull %excinfo.8, i64 %least.5.1449, i32 %.1531)
  switch i32 %.1541, label %B1138.endif.if [
    i32 -2, label %B1138.endif.endif
    i32 0, label %B1138.endif.endif
  ]

B1138.endif.if:
  %.1549 = icmp sgt i32 %.1541, 0
  %.1542 = load ptr, ptr %excinfo.8, align 8
  %.1550 = select i1 %.1549, ptr %.1542, ptr undef
  store ptr %.1550, ptr %excinfo, align 8
  br label %common.ret

B1138.endif.endif:
  %.1551 = load i64, ptr %.1537, align 8
  br label %B1220
}

define internal i32 @enlist.10(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.i, ptr noalias %arg.degree, ptr noalias %arg.head, ptr noalias %arg.after, ptr noalias %arg.before) {
entry:
  %.19 = getelementptr i32, ptr %arg.degree, i64 %arg.i
  %.20 = load i32, ptr %.19, align 4
  %.22 = sext i32 %.20 to i64
  %.23 = getelementptr i32, ptr %arg.head, i64 %.22
  %.24 = load i32, ptr %.23, align 4
  %.30 = getelementptr i32, ptr %arg.after, i64 %arg.i
  store i32 %.24, ptr %.30, align 4
  %.35 = getelementptr i32, ptr %arg.before, i64 %arg.i
  store i32 -1, ptr %.35, align 4
  %.39 = icmp sgt i32 %.24, -1
  br i1 %.39, label %B64, label %B74

B64:
  %.38 = zext nneg i32 %.24 to i64
  %.45 = trunc i64 %arg.i to i32
  %.46 = getelementptr i32, ptr %arg.before, i64 %.38
  store i32 %.45, ptr %.46, align 4
  br label %B74

B74:
  %.66 = trunc i64 %arg.i to i32
  store i32 %.66, ptr %.23, align 4
  store ptr null, ptr %retptr, align 8
  ret i32 0
}

define internal i32 @delist.11(ptr noalias %retptr, ptr noalias %excinfo, i32 %arg.i, ptr noalias %arg.degree, ptr noalias %arg.head, ptr noalias %arg.after, ptr noalias %arg.before) {
entry:
  %.21 = sext i32 %arg.i to i64
  %.22 = getelementptr i32, ptr %arg.before, i64 %.21
  %.23 = load i32, ptr %.22, align 4
  %.25 = icmp sgt i32 %.23, -1
  br i1 %.25, label %B28, label %B64

B28:
  %.24 = zext nneg i32 %.23 to i64
  %.34 = getelementptr i32, ptr %arg.after, i64 %.21
  %.35 = load i32, ptr %.34, align 4
  %.43 = getelementptr i32, ptr %arg.after, i64 %.24
  store i32 %.35, ptr %.43, align 4
  br label %B98

B64:
  %.49 = getelementptr i32, ptr %arg.after, i64 %.21
  %.50 = load i32, ptr %.49, align 4
  %.54 = getelementptr i32, ptr %arg.degree, i64 %.21
  %.55 = load i32, ptr %.54, align 4
  %.59 = sext i32 %.55 to i64
  %.60 = getelementptr i32, ptr %arg.head, i64 %.59
  store i32 %.50, ptr %.60, align 4
  br label %B98

B98:
  %.68 = getelementptr i32, ptr %arg.after, i64 %.21
  %.69 = load i32, ptr %.68, align 4
  %.71 = icmp sgt i32 %.69, -1
  br i1 %.71, label %B122, label %common.ret

common.ret:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B122:
  %.70 = zext nneg i32 %.69 to i64
  %.89 = getelementptr i32, ptr %arg.before, i64 %.70
  store i32 %.23, ptr %.89, align 4
  br label %common.ret
}

define internal i32 @merge.13(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.target, i64 %arg.source, i32 %arg.own, i32 %arg.gone, i64 %arg.free, i64 %arg.capacity, ptr noalias %arg.at, ptr noalias %arg.count, ptr noalias %arg.room, ptr noalias %arg.pool, ptr noalias %arg.mark) noinline {
entry:
  %.37 = getelementptr i32, ptr %arg.count, i64 %arg.target
  %.38 = load i32, ptr %.37, align 4
  %.40 = sext i32 %.38 to i64
  %.41 = add nsw i64 %arg.free, %.40
  %.44 = getelementptr i32, ptr %arg.count, i64 %arg.source
  %.45 = load i32, ptr %.44, align 4
  %.46 = sext i32 %.45 to i64
  %.47 = add nsw i64 %.41, %.46
  %.48 = icmp sgt i64 %.47, %arg.capacity
  br i1 %.48, label %common.ret, label %B56

common.ret:
  %arg.free.sink = phi i64 [ %arg.free, %B450 ], [ %end.2.1.lcssa, %B316 ], [ -1, %entry ]
  store i64 %arg.free.sink, ptr %retptr, align 8
  ret i32 0

B56:
  %.75 = sext i32 %arg.own to i64
  %.76 = trunc i64 %arg.free to i32
  %.77 = getelementptr i32, ptr %arg.mark, i64 %.75
  store i32 %.76, ptr %.77, align 4
  %.82 = sext i32 %arg.gone to i64
  %.84 = getelementptr i32, ptr %arg.mark, i64 %.82
  store i32 %.76, ptr %.84, align 4
  br label %B110.if

B110.loopexit:
  %end.2.1.lcssa = phi i64 [ %end.3.0176, %B110.if ], [ %end.4.2, %B268 ]
  br i1 %exitcond183.not, label %B272, label %B110.if

B238:
  store i32 %.76, ptr %.373, align 4
  %.389 = getelementptr i32, ptr %arg.pool, i64 %end.2.1173
  store i32 %.366, ptr %.389, align 4
  %.394 = add nsw i64 %end.2.1173, 1
  br label %B268

B268:
  %end.4.2 = phi i64 [ %.394, %B238 ], [ %end.2.1173, %B176.if ]
  %exitcond.not = icmp eq i64 %indvars.iv.next, %wide.trip.count
  br i1 %exitcond.not, label %B110.loopexit, label %B176.if

B272:
  %.428 = sub nsw i64 %end.2.1.lcssa, %arg.free
  %.435 = trunc i64 %.428 to i32
  store i32 %.435, ptr %.37, align 4
  %.442 = getelementptr i32, ptr %arg.room, i64 %arg.target
  %.443 = load i32, ptr %.442, align 4
  %.445 = sext i32 %.443 to i64
  %.446 = icmp sgt i64 %.428, %.445
  br i1 %.446, label %B316, label %B340

B316:
  %.460 = getelementptr i32, ptr %arg.at, i64 %arg.target
  store i32 %.76, ptr %.460, align 4
  store i32 %.435, ptr %.442, align 4
  br label %common.ret

B340:
  %.569177.not = icmp slt i64 %.428, 1
  br i1 %.569177.not, label %B450, label %B370.if.lr.ph

B370.if.lr.ph:
  %0 = getelementptr i32, ptr %arg.pool, i64 %arg.free
  %.614 = getelementptr i32, ptr %arg.at, i64 %arg.target
  %.615 = load i32, ptr %.614, align 4
  %.616 = sext i32 %.615 to i64
  %invariant.gep180 = getelementptr i32, ptr %arg.pool, i64 %.616
  br label %B370.if

B450:
  store i32 -1, ptr %.77, align 4
  store i32 -1, ptr %.84, align 4
  br label %common.ret

B110.if:
  %end.3.0176 = phi i64 [ %arg.free, %B56 ], [ %end.2.1.lcssa, %B110.loopexit ]
  %arg.target.arg.source = phi i64 [ %arg.target, %B56 ], [ %arg.source, %B110.loopexit ]
  %exitcond183.not = phi i1 [ false, %B56 ], [ true, %B110.loopexit ]
  %.234 = getelementptr i32, ptr %arg.count, i64 %arg.target.arg.source
  %.235 = load i32, ptr %.234, align 4
  %.315170.not = icmp slt i32 %.235, 1
  br i1 %.315170.not, label %B110.loopexit, label %B176.if.lr.ph

B176.if.lr.ph:
  %.359 = getelementptr i32, ptr %arg.at, i64 %arg.target.arg.source
  %.360 = load i32, ptr %.359, align 4
  %.361 = sext i32 %.360 to i64
  %invariant.gep = getelementptr i32, ptr %arg.pool, i64 %.361
  %wide.trip.count = zext nneg i32 %.235 to i64
  br label %B176.if

B176.if:
  %indvars.iv = phi i64 [ 0, %B176.if.lr.ph ], [ %indvars.iv.next, %B268 ]
  %end.2.1173 = phi i64 [ %end.3.0176, %B176.if.lr.ph ], [ %end.4.2, %B268 ]
  %indvars.iv.next = add nuw nsw i64 %indvars.iv, 1
  %gep = getelementptr i32, ptr %invariant.gep, i64 %indvars.iv
  %.366 = load i32, ptr %gep, align 4
  %.372 = sext i32 %.366 to i64
  %.373 = getelementptr i32, ptr %arg.mark, i64 %.372
  %.374 = load i32, ptr %.373, align 4
  %.376 = sext i32 %.374 to i64
  %.377.not = icmp eq i64 %arg.free, %.376
  br i1 %.377.not, label %B268, label %B238

B370.if:
  %.513.0178 = phi i64 [ 0, %B370.if.lr.ph ], [ %.582, %B370.if ]
  %.582 = add nuw nsw i64 %.513.0178, 1
  %.610 = getelementptr i32, ptr %0, i64 %.513.0178
  %.611 = load i32, ptr %.610, align 4
  %gep181 = getelementptr i32, ptr %invariant.gep180, i64 %.513.0178
  store i32 %.611, ptr %gep181, align 4
  %.625 = load i32, ptr %.610, align 4
  %.627 = sext i32 %.625 to i64
  %.629 = getelementptr i32, ptr %arg.mark, i64 %.627
  store i32 -1, ptr %.629, align 4
  %exitcond184.not = icmp eq i64 %.582, %.428
  br i1 %exitcond184.not, label %B450, label %B370.if
}

define internal i32 @enlist.12(ptr noalias %retptr, ptr noalias %excinfo, i32 %arg.i, ptr noalias %arg.degree, ptr noalias %arg.head, ptr noalias %arg.after, ptr noalias %arg.before) {
entry:
  %.19 = sext i32 %arg.i to i64
  %.20 = getelementptr i32, ptr %arg.degree, i64 %.19
  %.21 = load i32, ptr %.20, align 4
  %.23 = sext i32 %.21 to i64
  %.24 = getelementptr i32, ptr %arg.head, i64 %.23
  %.25 = load i32, ptr %.24, align 4
  %.32 = getelementptr i32, ptr %arg.after, i64 %.19
  store i32 %.25, ptr %.32, align 4
  %.38 = getelementptr i32, ptr %arg.before, i64 %.19
  store i32 -1, ptr %.38, align 4
  %.42 = icmp sgt i32 %.25, -1
  br i1 %.42, label %B64, label %B74

B64:
  %.41 = zext nneg i32 %.25 to i64
  %.48 = getelementptr i32, ptr %arg.before, i64 %.41
  store i32 %arg.i, ptr %.48, align 4
  br label %B74

B74:
  store i32 %arg.i, ptr %.24, align 4
  store ptr null, ptr %retptr, align 8
  ret i32 0
}

define internal i32 @numba.14(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.x.0, i32 %arg.x.1) {
entry:
  %.8 = sext i32 %arg.x.1 to i64
  %.10 = call i64 @llvm.smin.i64(i64 %arg.x.0, i64 %.8)
  store i64 %.10, ptr %retptr, align 8
  ret i32 0
}

define i64 @lu_pattern(i64 %a0, ptr %a1, ptr %a2, i64 %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7) {
  %r = alloca i64, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @lu_pattern.15(ptr nonnull %r, ptr nonnull %e, i64 %a0, ptr %a1, ptr %a2, i64 %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7)
  %v = load i64, ptr %r, align 8
  ret i64 %v
}

define internal i32 @lu_pattern.15(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.start, ptr noalias %arg.columns, i64 %arg.capacity, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.follow) noinline {
entry:
  %.114197.not = icmp slt i64 %arg.n, 1
  br i1 %.114197.not, label %common.ret, label %B40.if.preheader

B40.if.preheader:
  %0 = trunc i64 %arg.n to i32
  br label %B40.if

B168:
  %head.2.1.lcssa = phi i64 [ %arg.n, %B40.if ], [ %.294, %B124.if ]
  %.314 = icmp slt i64 %head.2.1.lcssa, %.55.0198
  br i1 %.314, label %B184, label %B430

B184:
  %k.2.1 = phi i64 [ %.537, %B402 ], [ %head.2.1.lcssa, %B168 ]
  %.325 = getelementptr i32, ptr %arg.diagonal, i64 %k.2.1
  %.326 = load i32, ptr %.325, align 4
  %.327 = sext i32 %.326 to i64
  %.328 = add nsw i64 %.327, 1
  %1 = getelementptr i32, ptr %arg.lu_start, i64 %k.2.1
  %.332 = getelementptr i8, ptr %1, i64 4
  %.333 = load i32, ptr %.332, align 4
  %.334 = sext i32 %.333 to i64
  %.371 = sub nsw i64 %.334, %.328
  %.414193.not = icmp slt i64 %.371, 1
  br i1 %.414193.not, label %B402, label %B256.if

B300:
  %before.4.3 = phi i64 [ %.479, %B300 ], [ %before.3.2196, %B256.if ]
  %.477 = getelementptr i32, ptr %arg.follow, i64 %before.4.3
  %.478 = load i32, ptr %.477, align 4
  %.479 = sext i32 %.478 to i64
  %.487 = getelementptr i32, ptr %arg.follow, i64 %.479
  %.488 = load i32, ptr %.487, align 4
  %.490 = icmp slt i32 %.488, %.462
  br i1 %.490, label %B300, label %B340

B340:
  %before.5.4 = phi i64 [ %before.3.2196, %B256.if ], [ %.479, %B300 ]
  %.496 = getelementptr i32, ptr %arg.follow, i64 %before.5.4
  %.497 = load i32, ptr %.496, align 4
  %.499 = icmp sgt i32 %.497, %.462
  br i1 %.499, label %B364, label %B396

B364:
  %.507 = sext i32 %.462 to i64
  %.508 = getelementptr i32, ptr %arg.follow, i64 %.507
  store i32 %.497, ptr %.508, align 4
  store i32 %.462, ptr %.496, align 4
  br label %B396

B396:
  %.523 = sext i32 %.462 to i64
  %.414 = icmp sgt i64 %.361.0195, 1
  br i1 %.414, label %B256.if, label %B402

B402:
  %.535 = getelementptr i32, ptr %arg.follow, i64 %k.2.1
  %.536 = load i32, ptr %.535, align 4
  %.537 = sext i32 %.536 to i64
  %.542 = icmp sgt i64 %.55.0198, %.537
  br i1 %.542, label %B184, label %B430

B430:
  %.562 = trunc i64 %count.2.0200 to i32
  %.563 = getelementptr i32, ptr %arg.lu_start, i64 %.55.0198
  store i32 %.562, ptr %.563, align 4
  %.574 = icmp slt i64 %head.2.1.lcssa, %arg.n
  br i1 %.574, label %B456.preheader, label %B544

B456.preheader:
  %.619 = getelementptr i32, ptr %arg.diagonal, i64 %.55.0198
  br label %B456

B456:
  %count.4.1 = phi i64 [ %.629, %B496 ], [ %count.2.0200, %B456.preheader ]
  %column.3.1 = phi i64 [ %.638, %B496 ], [ %head.2.1.lcssa, %B456.preheader ]
  %.583 = icmp eq i64 %count.4.1, %arg.capacity
  br i1 %.583, label %common.ret, label %B474

common.ret:
  %storemerge184 = phi i64 [ -1, %B456 ], [ 0, %entry ], [ %count.3.2, %B544 ]
  store i64 %storemerge184, ptr %retptr, align 8
  ret i32 0

B474:
  %.613 = icmp eq i64 %column.3.1, %.55.0198
  br i1 %.613, label %B486, label %B496

B486:
  %.618 = trunc i64 %count.4.1 to i32
  store i32 %.618, ptr %.619, align 4
  br label %B496

B496:
  %.625 = trunc i64 %column.3.1 to i32
  %.626 = getelementptr i32, ptr %arg.lu_columns, i64 %count.4.1
  store i32 %.625, ptr %.626, align 4
  %.629 = add nsw i64 %count.4.1, 1
  %.636 = getelementptr i32, ptr %arg.follow, i64 %column.3.1
  %.637 = load i32, ptr %.636, align 4
  %.638 = sext i32 %.637 to i64
  %.643 = icmp sgt i64 %arg.n, %.638
  br i1 %.643, label %B456, label %B544

B544:
  %count.3.2 = phi i64 [ %count.2.0200, %B430 ], [ %.629, %B496 ]
  %.663 = trunc i64 %count.3.2 to i32
  %.664 = getelementptr i32, ptr %arg.lu_start, i64 %.127
  store i32 %.663, ptr %.664, align 4
  %exitcond.not = icmp eq i64 %arg.n, %.127
  br i1 %exitcond.not, label %common.ret, label %B40.if

B40.if:
  %count.2.0200 = phi i64 [ %count.3.2, %B544 ], [ 0, %B40.if.preheader ]
  %.55.0198 = phi i64 [ %.127, %B544 ], [ 0, %B40.if.preheader ]
  %.127 = add nuw nsw i64 %.55.0198, 1
  %.162 = getelementptr i32, ptr %arg.start, i64 %.127
  %.163 = load i32, ptr %.162, align 4
  %.164 = sext i32 %.163 to i64
  %.168 = getelementptr i32, ptr %arg.start, i64 %.55.0198
  %.169 = load i32, ptr %.168, align 4
  %.170 = sext i32 %.169 to i64
  %.208 = sub nsw i64 %.170, %.164
  %.209 = icmp sgt i64 %.208, 0
  %.228 = sub nsw i64 0, %.208
  %storemerge185 = select i1 %.209, i64 0, i64 %.228
  %.251189 = icmp sgt i64 %storemerge185, 0
  br i1 %.251189, label %B124.if, label %B168

B124.if:
  %head.2.1192 = phi i32 [ %.291, %B124.if ], [ %0, %B40.if ]
  %.198.0191 = phi i64 [ %.260, %B124.if ], [ %storemerge185, %B40.if ]
  %.195.0.in190 = phi i64 [ %.195.0, %B124.if ], [ %.164, %B40.if ]
  %.195.0 = add nsw i64 %.195.0.in190, -1
  %.260 = add nsw i64 %.198.0191, -1
  %.290 = getelementptr i32, ptr %arg.columns, i64 %.195.0
  %.291 = load i32, ptr %.290, align 4
  %.294 = sext i32 %.291 to i64
  %.296 = getelementptr i32, ptr %arg.follow, i64 %.294
  store i32 %head.2.1192, ptr %.296, align 4
  %.251 = icmp sgt i64 %.198.0191, 1
  br i1 %.251, label %B124.if, label %B168

B256.if:
  %before.3.2196 = phi i64 [ %.523, %B396 ], [ %k.2.1, %B184 ]
  %.361.0195 = phi i64 [ %.423, %B396 ], [ %.371, %B184 ]
  %.358.0194 = phi i64 [ %.427, %B396 ], [ %.328, %B184 ]
  %.423 = add nsw i64 %.361.0195, -1
  %.427 = add nsw i64 %.358.0194, 1
  %.461 = getelementptr i32, ptr %arg.lu_columns, i64 %.358.0194
  %.462 = load i32, ptr %.461, align 4
  %.468 = getelementptr i32, ptr %arg.follow, i64 %before.3.2196
  %.469 = load i32, ptr %.468, align 4
  %.473 = icmp slt i32 %.469, %.462
  br i1 %.473, label %B300, label %B340
}

define i64 @lu_fill(i64 %a0, i64 %a1, ptr %a2, ptr %a3, ptr %a4, double %a5, ptr %a6) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @lu_fill.16(ptr nonnull %r, ptr nonnull %e, i64 %a0, i64 %a1, ptr %a2, ptr %a3, ptr %a4, double %a5, ptr %a6)
  ret i64 0
}

define internal i32 @lu_fill.16(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, i64 %arg.count, ptr noalias %arg.J, ptr noalias %arg.own, ptr noalias %arg.mass, double %arg.scale, ptr noalias %arg.lu) noinline {
entry:
  %0 = call i64 @llvm.smax.i64(i64 %arg.count, i64 0)
  %storemerge = shl i64 %0, 2
  %.10573 = icmp sgt i64 %storemerge, 0
  br i1 %.10573, label %B40.if, label %B70

B70:
  %.23776.not = icmp slt i64 %arg.n, 1
  br i1 %.23776.not, label %B168, label %B100.if

B168:
  %.303 = getelementptr i32, ptr %arg.own, i64 %arg.n
  %.304 = load i32, ptr %.303, align 4
  %.306 = icmp sgt i32 %.304, -1
  br i1 %.306, label %B192, label %common.ret

common.ret:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B192:
  %.305 = zext nneg i32 %.304 to i64
  %.318 = getelementptr double, ptr %arg.lu, i64 %.305
  store double 1.000000e+00, ptr %.318, align 8
  br label %common.ret

B40.if:
  %.47.074 = phi i64 [ %.118, %B40.if ], [ 0, %entry ]
  %.118 = add nuw nsw i64 %.47.074, 1
  %.144 = getelementptr double, ptr %arg.J, i64 %.47.074
  %.145 = load double, ptr %.144, align 8
  %.146 = fneg contract double %.145
  %.148 = getelementptr double, ptr %arg.lu, i64 %.47.074
  store double %.146, ptr %.148, align 8
  %exitcond.not = icmp eq i64 %.118, %storemerge
  br i1 %exitcond.not, label %B70, label %B40.if

B100.if:
  %.181.077 = phi i64 [ %.250, %B100.if ], [ 0, %B70 ]
  %.250 = add nuw nsw i64 %.181.077, 1
  %.276 = getelementptr i32, ptr %arg.own, i64 %.181.077
  %.277 = load i32, ptr %.276, align 4
  %.279 = sext i32 %.277 to i64
  %.280 = getelementptr double, ptr %arg.lu, i64 %.279
  %.281 = load double, ptr %.280, align 8
  %.283 = getelementptr double, ptr %arg.mass, i64 %.181.077
  %.284 = load double, ptr %.283, align 8
  %.286 = fmul contract double %arg.scale, %.284
  %.287 = fadd contract double %.281, %.286
  store double %.287, ptr %.280, align 8
  %exitcond79.not = icmp eq i64 %arg.n, %.250
  br i1 %exitcond79.not, label %B168, label %B100.if
}

define i64 @lu_factor(i64 %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5) {
  %r = alloca i64, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @lu_factor.17(ptr nonnull %r, ptr nonnull %e, i64 %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5)
  %v = load i64, ptr %r, align 8
  ret i64 %v
}

define internal i32 @lu_factor.17(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.blocks, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.lu, ptr noalias %arg.row) noinline {
entry:
  %.295 = alloca ptr, align 8
  store ptr null, ptr %.295, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.932 = alloca ptr, align 8
  store ptr null, ptr %.932, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.102226.not = icmp slt i64 %arg.blocks, 1
  br i1 %.102226.not, label %B1560, label %B36.if

B192:
  %.364 = sub i32 %.150, %.146
  %.408220.not = icmp slt i32 %.364, 1
  br i1 %.408220.not, label %B1176, label %B226.if

B224.loopexit:
  %.408 = icmp sgt i32 %.354.0222, 1
  br i1 %.408, label %B226.if, label %B1176

B1176:
  %.840 = sub i32 %.155, %.150
  %.883223.not = icmp slt i32 %.840, 1
  br i1 %.883223.not, label %B1274, label %B1208.if

B1274:
  %.962 = sext i32 %.150 to i64
  %.971.idx = shl nsw i64 %.962, 5
  %.971 = getelementptr i8, ptr %arg.lu, i64 %.971.idx
  %.972 = load double, ptr %.971, align 8
  %.976 = getelementptr i8, ptr %.971, i64 8
  %.977 = load double, ptr %.976, align 8
  %.981 = getelementptr i8, ptr %.971, i64 16
  %.982 = load double, ptr %.981, align 8
  %.986 = getelementptr i8, ptr %.971, i64 24
  %.987 = load double, ptr %.986, align 8
  %.1010 = fmul contract double %.972, %.987
  %.1013 = fmul contract double %.977, %.982
  %.1014 = fsub contract double %.1010, %.1013
  %.1019 = fcmp contract une double %.1014, 0.000000e+00
  %.1022 = fsub contract double %.1014, %.1014
  %.1023 = fcmp contract ord double %.1022, 0.000000e+00
  %or.cond = and i1 %.1019, %.1023
  br i1 %or.cond, label %B1460, label %B1446

common.ret:
  %common.ret.op = phi i32 [ 0, %B1446 ], [ 0, %B1560 ], [ %.936, %B1210.if ], [ %.299, %B128.if ]
  ret i32 %common.ret.op

B1446:
  store i64 %.115, ptr %retptr, align 8
  br label %common.ret

B1460:
  %.1061 = fdiv contract double 1.000000e+00, %.1014
  %.1065 = fmul contract double %.987, %.1061
  store double %.1065, ptr %.971, align 8
  %.1073 = fneg contract double %.977
  %.1076 = fmul contract double %.1061, %.1073
  store double %.1076, ptr %.976, align 8
  %.1083 = fneg contract double %.982
  %.1086 = fmul contract double %.1061, %.1083
  store double %.1086, ptr %.981, align 8
  %.1093 = fmul contract double %.972, %.1061
  store double %.1093, ptr %.986, align 8
  %exitcond.not = icmp eq i64 %arg.blocks, %.115
  br i1 %exitcond.not, label %B1560, label %B36.if

B1560:
  store i64 0, ptr %retptr, align 8
  br label %common.ret

B36.if:
  %.43.0227 = phi i64 [ %.115, %B1460 ], [ 0, %entry ]
  %.115 = add nuw nsw i64 %.43.0227, 1
  %.145 = getelementptr i32, ptr %arg.lu_start, i64 %.43.0227
  %.146 = load i32, ptr %.145, align 4
  %.149 = getelementptr i32, ptr %arg.diagonal, i64 %.43.0227
  %.150 = load i32, ptr %.149, align 4
  %.154 = getelementptr i32, ptr %arg.lu_start, i64 %.115
  %.155 = load i32, ptr %.154, align 4
  %.203 = sub i32 %.155, %.146
  %.246214.not = icmp slt i32 %.203, 1
  br i1 %.246214.not, label %B192, label %B126.if

B126.if:
  %.193.0216 = phi i32 [ %.255, %B128.endif ], [ %.203, %B36.if ]
  %.190.0215 = phi i32 [ %.259, %B128.endif ], [ %.146, %B36.if ]
  %0 = sext i32 %.190.0215 to i64
  %.286 = shl nsw i64 %0, 2
  %.289 = getelementptr i32, ptr %arg.lu_columns, i64 %0
  %.290 = load i32, ptr %.289, align 4
  %.291 = sext i32 %.290 to i64
  %.292 = shl nsw i64 %.291, 2
  store ptr null, ptr %.295, align 8
  %.299 = call i32 @copy_block.18(ptr nonnull %.295, ptr nonnull %excinfo.1, ptr %arg.lu, i64 %.286, ptr %arg.row, i64 %.292)
  switch i32 %.299, label %B128.if [
    i32 -2, label %B128.endif
    i32 0, label %B128.endif
  ]

B128.if:
  %.307 = icmp sgt i32 %.299, 0
  %.300 = load ptr, ptr %excinfo.1, align 8
  %.308 = select i1 %.307, ptr %.300, ptr undef
  store ptr %.308, ptr %excinfo, align 8
  br label %common.ret

B128.endif:
  %.259 = add i32 %.190.0215, 1
  %.255 = add nsw i32 %.193.0216, -1
  %.246 = icmp sgt i32 %.193.0216, 1
  br i1 %.246, label %B126.if, label %B192

B226.if:
  %.354.0222 = phi i32 [ %.417, %B224.loopexit ], [ %.364, %B192 ]
  %.351.0221 = phi i32 [ %.421, %B224.loopexit ], [ %.146, %B192 ]
  %.417 = add nsw i32 %.354.0222, -1
  %.421 = add i32 %.351.0221, 1
  %1 = sext i32 %.351.0221 to i64
  %.448 = getelementptr i32, ptr %arg.lu_columns, i64 %1
  %.449 = load i32, ptr %.448, align 4
  %.450 = sext i32 %.449 to i64
  %.454 = getelementptr i32, ptr %arg.diagonal, i64 %.450
  %.455 = load i32, ptr %.454, align 4
  %.456 = sext i32 %.455 to i64
  %.461.idx = shl nsw i64 %.450, 5
  %.461 = getelementptr i8, ptr %arg.row, i64 %.461.idx
  %.462 = load double, ptr %.461, align 8
  %.464.idx = shl nsw i64 %.456, 5
  %.464 = getelementptr i8, ptr %arg.lu, i64 %.464.idx
  %.465 = load double, ptr %.464, align 8
  %.466 = fmul contract double %.462, %.465
  %.469 = getelementptr i8, ptr %.461, i64 8
  %.470 = load double, ptr %.469, align 8
  %.473 = getelementptr i8, ptr %.464, i64 16
  %.474 = load double, ptr %.473, align 8
  %.475 = fmul contract double %.470, %.474
  %.476 = fadd contract double %.466, %.475
  %.485 = getelementptr i8, ptr %.464, i64 8
  %.486 = load double, ptr %.485, align 8
  %.487 = fmul contract double %.462, %.486
  %.494 = getelementptr i8, ptr %.464, i64 24
  %.495 = load double, ptr %.494, align 8
  %.496 = fmul contract double %.470, %.495
  %.497 = fadd contract double %.487, %.496
  %.503 = getelementptr i8, ptr %.461, i64 16
  %.504 = load double, ptr %.503, align 8
  %.508 = fmul contract double %.465, %.504
  %.511 = getelementptr i8, ptr %.461, i64 24
  %.512 = load double, ptr %.511, align 8
  %.517 = fmul contract double %.474, %.512
  %.518 = fadd contract double %.508, %.517
  %.530 = fmul contract double %.486, %.504
  %.539 = fmul contract double %.495, %.512
  %.540 = fadd contract double %.530, %.539
  %.546.idx = shl nsw i64 %1, 5
  %.546 = getelementptr i8, ptr %arg.lu, i64 %.546.idx
  store double %.476, ptr %.546, align 8
  %.551 = getelementptr i8, ptr %.546, i64 8
  store double %.497, ptr %.551, align 8
  %.556 = getelementptr i8, ptr %.546, i64 16
  store double %.518, ptr %.556, align 8
  %.561 = getelementptr i8, ptr %.546, i64 24
  store double %.540, ptr %.561, align 8
  %.568 = add nsw i64 %.456, 1
  %2 = getelementptr i32, ptr %arg.lu_start, i64 %.450
  %.572 = getelementptr i8, ptr %2, i64 4
  %.573 = load i32, ptr %.572, align 4
  %.574 = sext i32 %.573 to i64
  %.611 = sub nsw i64 %.574, %.568
  %.654217.not = icmp slt i64 %.611, 1
  br i1 %.654217.not, label %B224.loopexit, label %B766.if

B766.if:
  %.601.0219 = phi i64 [ %.663, %B766.if ], [ %.611, %B226.if ]
  %.598.0218 = phi i64 [ %.667, %B766.if ], [ %.568, %B226.if ]
  %.663 = add nsw i64 %.601.0219, -1
  %.667 = add nsw i64 %.598.0218, 1
  %.693 = getelementptr i32, ptr %arg.lu_columns, i64 %.598.0218
  %.694 = load i32, ptr %.693, align 4
  %.695 = sext i32 %.694 to i64
  %.699.idx = shl nsw i64 %.695, 5
  %.699 = getelementptr i8, ptr %arg.row, i64 %.699.idx
  %.700 = load double, ptr %.699, align 8
  %.702.idx = shl i64 %.598.0218, 5
  %.702 = getelementptr i8, ptr %arg.lu, i64 %.702.idx
  %.703 = load double, ptr %.702, align 8
  %.705 = fmul contract double %.476, %.703
  %.706 = fsub contract double %.700, %.705
  %.709 = getelementptr i8, ptr %.702, i64 16
  %.710 = load double, ptr %.709, align 8
  %.712 = fmul contract double %.497, %.710
  %.713 = fsub contract double %.706, %.712
  %.716 = getelementptr i8, ptr %.699, i64 8
  %.717 = load double, ptr %.716, align 8
  %.720 = getelementptr i8, ptr %.702, i64 8
  %.721 = load double, ptr %.720, align 8
  %.723 = fmul contract double %.476, %.721
  %.724 = fsub contract double %.717, %.723
  %.727 = getelementptr i8, ptr %.702, i64 24
  %.728 = load double, ptr %.727, align 8
  %.730 = fmul contract double %.497, %.728
  %.731 = fsub contract double %.724, %.730
  %.734 = getelementptr i8, ptr %.699, i64 16
  %.735 = load double, ptr %.734, align 8
  %.740 = fmul contract double %.518, %.703
  %.741 = fsub contract double %.735, %.740
  %.747 = fmul contract double %.540, %.710
  %.748 = fsub contract double %.741, %.747
  %.751 = getelementptr i8, ptr %.699, i64 24
  %.752 = load double, ptr %.751, align 8
  %.758 = fmul contract double %.518, %.721
  %.759 = fsub contract double %.752, %.758
  %.765 = fmul contract double %.540, %.728
  %.766 = fsub contract double %.759, %.765
  store double %.713, ptr %.699, align 8
  store double %.731, ptr %.716, align 8
  store double %.748, ptr %.734, align 8
  store double %.766, ptr %.751, align 8
  %.654 = icmp sgt i64 %.601.0219, 1
  br i1 %.654, label %B766.if, label %B224.loopexit

B1208.if:
  %.830.0225 = phi i32 [ %.892, %B1210.endif ], [ %.840, %B1176 ]
  %.827.0224 = phi i32 [ %.896, %B1210.endif ], [ %.150, %B1176 ]
  %3 = sext i32 %.827.0224 to i64
  %.924 = getelementptr i32, ptr %arg.lu_columns, i64 %3
  %.925 = load i32, ptr %.924, align 4
  %.926 = sext i32 %.925 to i64
  %.927 = shl nsw i64 %.926, 2
  %.929 = shl nsw i64 %3, 2
  store ptr null, ptr %.932, align 8
  %.936 = call i32 @copy_block.18(ptr nonnull %.932, ptr nonnull %excinfo.2, ptr %arg.row, i64 %.927, ptr %arg.lu, i64 %.929)
  switch i32 %.936, label %B1210.if [
    i32 -2, label %B1210.endif
    i32 0, label %B1210.endif
  ]

B1210.if:
  %.944 = icmp sgt i32 %.936, 0
  %.937 = load ptr, ptr %excinfo.2, align 8
  %.945 = select i1 %.944, ptr %.937, ptr undef
  store ptr %.945, ptr %excinfo, align 8
  br label %common.ret

B1210.endif:
  %.896 = add i32 %.827.0224, 1
  %.892 = add nsw i32 %.830.0225, -1
  %.883 = icmp sgt i32 %.830.0225, 1
  br i1 %.883, label %B1208.if, label %B1274
}

define internal i32 @copy_block.18(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.source, i64 %arg.at, ptr noalias %arg.target, i64 %arg.to) {
entry:
  %0 = getelementptr double, ptr %arg.source, i64 %arg.at
  %1 = getelementptr double, ptr %arg.target, i64 %arg.to
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 dereferenceable(32) %1, ptr nonnull align 8 dereferenceable(32) %0, i64 32, i1 false)
  store ptr null, ptr %retptr, align 8
  ret i32 0
}

define i64 @lu_solve(i64 %a0, ptr %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @lu_solve.19(ptr nonnull %r, ptr nonnull %e, i64 %a0, ptr %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9)
  ret i64 0
}

define internal i32 @lu_solve.19(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.slots, i64 %arg.blocks, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.lu, ptr noalias %arg.right, ptr noalias %arg.solution, ptr noalias %arg.x) noinline {
entry:
  %0 = call i64 @llvm.smax.i64(i64 %arg.blocks, i64 0)
  %storemerge = shl nuw i64 %0, 1
  %.117264 = icmp sgt i64 %storemerge, 0
  br i1 %.117264, label %B40.if.preheader, label %B56

B40.if.preheader:
  %1 = shl i64 %0, 4
  call void @llvm.memset.p0.i64(ptr align 8 %arg.x, i8 0, i64 %1, i1 false)
  br label %B56

B56:
  %.243267.not = icmp slt i64 %arg.n, 1
  br i1 %.243267.not, label %B126, label %B86.if

B126:
  %.378276.not = icmp slt i64 %arg.blocks, 1
  br i1 %.378276.not, label %B518, label %B156.if

B478:
  %second.4.1.lcssa = phi double [ %.429, %B156.if ], [ %.608, %B266.if ]
  %first.4.1.lcssa = phi double [ %.423, %B156.if ], [ %.593, %B266.if ]
  store double %first.4.1.lcssa, ptr %.422, align 8
  store double %second.4.1.lcssa, ptr %.428, align 8
  %exitcond293.not = icmp eq i64 %arg.blocks, %.391
  br i1 %exitcond293.not, label %B518, label %B156.if

B518:
  %.723287.not = icmp slt i64 %arg.blocks, 1
  br i1 %.723287.not, label %B1086.preheader, label %B558.if

B1086.preheader:
  %.1105290.not = icmp slt i64 %arg.n, 1
  br i1 %.1105290.not, label %B1126, label %B1086.if

B892:
  %second.5.1.lcssa = phi double [ %.774, %B558.if ], [ %.954, %B680.if ]
  %first.5.1.lcssa = phi double [ %.768, %B558.if ], [ %.939, %B680.if ]
  %.969.idx = shl nsw i64 %.785, 5
  %.969 = getelementptr i8, ptr %arg.lu, i64 %.969.idx
  %.970 = load double, ptr %.969, align 8
  %.972 = fmul contract double %first.5.1.lcssa, %.970
  %.975 = getelementptr i8, ptr %.969, i64 8
  %.976 = load double, ptr %.975, align 8
  %.978 = fmul contract double %second.5.1.lcssa, %.976
  %.979 = fadd contract double %.972, %.978
  store double %.979, ptr %.767, align 8
  %.987 = getelementptr i8, ptr %.969, i64 16
  %.988 = load double, ptr %.987, align 8
  %.990 = fmul contract double %first.5.1.lcssa, %.988
  %.995 = getelementptr i8, ptr %.969, i64 24
  %.996 = load double, ptr %.995, align 8
  %.998 = fmul contract double %second.5.1.lcssa, %.996
  %.1001 = fadd contract double %.990, %.998
  store double %.1001, ptr %.773, align 8
  %.723 = icmp sgt i64 %.670.0288, 1
  br i1 %.723, label %B558.if, label %B1086.preheader

B1126:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B86.if:
  %.187.0268 = phi i64 [ %.256, %B86.if ], [ 0, %B56 ]
  %.256 = add nuw nsw i64 %.187.0268, 1
  %.282 = getelementptr double, ptr %arg.right, i64 %.187.0268
  %.283 = load double, ptr %.282, align 8
  %.285 = getelementptr i32, ptr %arg.slots, i64 %.187.0268
  %.286 = load i32, ptr %.285, align 4
  %.288 = sext i32 %.286 to i64
  %.289 = getelementptr double, ptr %arg.x, i64 %.288
  store double %.283, ptr %.289, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.256
  br i1 %exitcond.not, label %B126, label %B86.if

B156.if:
  %.322.0277 = phi i64 [ %.391, %B478 ], [ 0, %B126 ]
  %.391 = add nuw nsw i64 %.322.0277, 1
  %.422.idx = shl i64 %.322.0277, 4
  %.422 = getelementptr i8, ptr %arg.x, i64 %.422.idx
  %.423 = load double, ptr %.422, align 8
  %.428 = getelementptr i8, ptr %.422, i64 8
  %.429 = load double, ptr %.428, align 8
  %.438 = getelementptr i32, ptr %arg.lu_start, i64 %.322.0277
  %.439 = load i32, ptr %.438, align 4
  %.442 = getelementptr i32, ptr %arg.diagonal, i64 %.322.0277
  %.443 = load i32, ptr %.442, align 4
  %.480 = sub i32 %.443, %.439
  %.523270.not = icmp slt i32 %.480, 1
  br i1 %.523270.not, label %B478, label %B266.if

B266.if:
  %first.4.1274 = phi double [ %.593, %B266.if ], [ %.423, %B156.if ]
  %second.4.1273 = phi double [ %.608, %B266.if ], [ %.429, %B156.if ]
  %.470.0272 = phi i32 [ %.532, %B266.if ], [ %.480, %B156.if ]
  %.467.0271 = phi i32 [ %.536, %B266.if ], [ %.439, %B156.if ]
  %.532 = add nsw i32 %.470.0272, -1
  %.536 = add i32 %.467.0271, 1
  %2 = sext i32 %.467.0271 to i64
  %.565 = getelementptr i32, ptr %arg.lu_columns, i64 %2
  %.566 = load i32, ptr %.565, align 4
  %.567 = sext i32 %.566 to i64
  %.570.idx = shl nsw i64 %.567, 4
  %.570 = getelementptr i8, ptr %arg.x, i64 %.570.idx
  %.571 = load double, ptr %.570, align 8
  %.580 = getelementptr i8, ptr %.570, i64 8
  %.581 = load double, ptr %.580, align 8
  %.583.idx = shl nsw i64 %2, 5
  %.583 = getelementptr i8, ptr %arg.lu, i64 %.583.idx
  %.584 = load double, ptr %.583, align 8
  %.585 = fmul contract double %.571, %.584
  %.588 = getelementptr i8, ptr %.583, i64 8
  %.589 = load double, ptr %.588, align 8
  %.590 = fmul contract double %.581, %.589
  %.591 = fadd contract double %.585, %.590
  %.593 = fsub contract double %first.4.1274, %.591
  %.598 = getelementptr i8, ptr %.583, i64 16
  %.599 = load double, ptr %.598, align 8
  %.600 = fmul contract double %.571, %.599
  %.603 = getelementptr i8, ptr %.583, i64 24
  %.604 = load double, ptr %.603, align 8
  %.605 = fmul contract double %.581, %.604
  %.606 = fadd contract double %.600, %.605
  %.608 = fsub contract double %second.4.1273, %.606
  %.523 = icmp sgt i32 %.470.0272, 1
  br i1 %.523, label %B266.if, label %B478

B558.if:
  %.667.0289.in = phi i64 [ %.667.0289, %B892 ], [ %arg.blocks, %B518 ]
  %.670.0288 = phi i64 [ %.732, %B892 ], [ %arg.blocks, %B518 ]
  %.667.0289 = add i64 %.667.0289.in, -1
  %.732 = add nsw i64 %.670.0288, -1
  %.767.idx = shl i64 %.667.0289, 4
  %.767 = getelementptr i8, ptr %arg.x, i64 %.767.idx
  %.768 = load double, ptr %.767, align 8
  %.773 = getelementptr i8, ptr %.767, i64 8
  %.774 = load double, ptr %.773, align 8
  %.783 = getelementptr i32, ptr %arg.diagonal, i64 %.667.0289
  %.784 = load i32, ptr %.783, align 4
  %.785 = sext i32 %.784 to i64
  %.786 = add nsw i64 %.785, 1
  %3 = getelementptr i32, ptr %arg.lu_start, i64 %.667.0289
  %.790 = getelementptr i8, ptr %3, i64 4
  %.791 = load i32, ptr %.790, align 4
  %.792 = sext i32 %.791 to i64
  %.829 = sub nsw i64 %.792, %.786
  %.872279.not = icmp slt i64 %.829, 1
  br i1 %.872279.not, label %B892, label %B680.if

B680.if:
  %first.5.1283 = phi double [ %.939, %B680.if ], [ %.768, %B558.if ]
  %second.5.1282 = phi double [ %.954, %B680.if ], [ %.774, %B558.if ]
  %.819.0281 = phi i64 [ %.881, %B680.if ], [ %.829, %B558.if ]
  %.816.0280 = phi i64 [ %.885, %B680.if ], [ %.786, %B558.if ]
  %.881 = add nsw i64 %.819.0281, -1
  %.885 = add nsw i64 %.816.0280, 1
  %.912 = getelementptr i32, ptr %arg.lu_columns, i64 %.816.0280
  %.913 = load i32, ptr %.912, align 4
  %.914 = sext i32 %.913 to i64
  %.917.idx = shl nsw i64 %.914, 4
  %.917 = getelementptr i8, ptr %arg.x, i64 %.917.idx
  %.918 = load double, ptr %.917, align 8
  %.926 = getelementptr i8, ptr %.917, i64 8
  %.927 = load double, ptr %.926, align 8
  %.929.idx = shl i64 %.816.0280, 5
  %.929 = getelementptr i8, ptr %arg.lu, i64 %.929.idx
  %.930 = load double, ptr %.929, align 8
  %.931 = fmul contract double %.918, %.930
  %.934 = getelementptr i8, ptr %.929, i64 8
  %.935 = load double, ptr %.934, align 8
  %.936 = fmul contract double %.927, %.935
  %.937 = fadd contract double %.931, %.936
  %.939 = fsub contract double %first.5.1283, %.937
  %.944 = getelementptr i8, ptr %.929, i64 16
  %.945 = load double, ptr %.944, align 8
  %.946 = fmul contract double %.918, %.945
  %.949 = getelementptr i8, ptr %.929, i64 24
  %.950 = load double, ptr %.949, align 8
  %.951 = fmul contract double %.927, %.950
  %.952 = fadd contract double %.946, %.951
  %.954 = fsub contract double %second.5.1282, %.952
  %.872 = icmp sgt i64 %.819.0281, 1
  br i1 %.872, label %B680.if, label %B892

B1086.if:
  %.1049.0291 = phi i64 [ %.1118, %B1086.if ], [ 0, %B1086.preheader ]
  %.1118 = add nuw nsw i64 %.1049.0291, 1
  %.1144 = getelementptr i32, ptr %arg.slots, i64 %.1049.0291
  %.1145 = load i32, ptr %.1144, align 4
  %.1147 = sext i32 %.1145 to i64
  %.1148 = getelementptr double, ptr %arg.x, i64 %.1147
  %.1149 = load double, ptr %.1148, align 8
  %.1151 = getelementptr double, ptr %arg.solution, i64 %.1049.0291
  store double %.1149, ptr %.1151, align 8
  %exitcond294.not = icmp eq i64 %arg.n, %.1118
  br i1 %exitcond294.not, label %B1126, label %B1086.if
}

define i64 @march(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, i64 %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, ptr %a14, i64 %a15, ptr %a16, ptr %a17, ptr %a18, ptr %a19, i64 %a20, i64 %a21, ptr %a22, ptr %a23, ptr %a24, ptr %a25, ptr %a26, i64 %a27, ptr %a28, ptr %a29) {
  %r = alloca i64, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @march.20(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, i64 %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, ptr %a14, i64 %a15, ptr %a16, ptr %a17, ptr %a18, ptr %a19, i64 %a20, i64 %a21, ptr %a22, ptr %a23, ptr %a24, ptr %a25, ptr %a26, i64 %a27, ptr %a28, ptr %a29)
  %v = load i64, ptr %r, align 8
  ret i64 %v
}

define internal i32 @march.20(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.pos, ptr noalias %arg.numbers, ptr noalias %arg.drive_rows, ptr noalias %arg.drive_columns, i64 %arg.blocks, ptr noalias %arg.own, ptr noalias %arg.slots, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.mass, i64 %arg.tested, ptr noalias %arg.powers, ptr noalias %arg.method, ptr noalias %arg.settings, ptr noalias %arg.edges, i64 %arg.edge_count, i64 %arg.max_steps, ptr noalias %arg.y, ptr noalias %arg.Y, ptr noalias %arg.state, ptr noalias %arg.counts, ptr noalias %arg.outputs, i64 %arg.most_recorded, ptr noalias %arg.record, ptr noalias %arg.work) noinline {
entry:
  %.485 = alloca double, align 8
  store double 0.000000e+00, ptr %.485, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.541 = alloca ptr, align 8
  store ptr null, ptr %.541, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.594 = alloca ptr, align 8
  store ptr null, ptr %.594, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.625 = alloca i64, align 8
  store i64 0, ptr %.625, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.687 = alloca ptr, align 8
  store ptr null, ptr %.687, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.727 = alloca ptr, align 8
  store ptr null, ptr %.727, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.754 = alloca ptr, align 8
  store ptr null, ptr %.754, align 8
  %excinfo.7 = alloca ptr, align 8
  store ptr null, ptr %excinfo.7, align 8
  %.788 = alloca double, align 8
  store double 0.000000e+00, ptr %.788, align 8
  %excinfo.8 = alloca ptr, align 8
  store ptr null, ptr %excinfo.8, align 8
  %.823 = alloca double, align 8
  store double 0.000000e+00, ptr %.823, align 8
  %excinfo.9 = alloca ptr, align 8
  store ptr null, ptr %excinfo.9, align 8
  %.872 = alloca double, align 8
  store double 0.000000e+00, ptr %.872, align 8
  %excinfo.10 = alloca ptr, align 8
  store ptr null, ptr %excinfo.10, align 8
  %.1145 = alloca ptr, align 8
  store ptr null, ptr %.1145, align 8
  %excinfo.11 = alloca ptr, align 8
  store ptr null, ptr %excinfo.11, align 8
  %.1191 = alloca double, align 8
  store double 0.000000e+00, ptr %.1191, align 8
  %excinfo.12 = alloca ptr, align 8
  store ptr null, ptr %excinfo.12, align 8
  %.1242 = alloca ptr, align 8
  store ptr null, ptr %.1242, align 8
  %excinfo.13 = alloca ptr, align 8
  store ptr null, ptr %excinfo.13, align 8
  %.1284 = alloca ptr, align 8
  store ptr null, ptr %.1284, align 8
  %excinfo.14 = alloca ptr, align 8
  store ptr null, ptr %excinfo.14, align 8
  %.1410 = alloca double, align 8
  store double 0.000000e+00, ptr %.1410, align 8
  %excinfo.15 = alloca ptr, align 8
  store ptr null, ptr %excinfo.15, align 8
  %.1452 = alloca double, align 8
  store double 0.000000e+00, ptr %.1452, align 8
  %excinfo.16 = alloca ptr, align 8
  store ptr null, ptr %excinfo.16, align 8
  %.1507 = alloca double, align 8
  store double 0.000000e+00, ptr %.1507, align 8
  %excinfo.17 = alloca ptr, align 8
  store ptr null, ptr %excinfo.17, align 8
  %.1539 = alloca double, align 8
  store double 0.000000e+00, ptr %.1539, align 8
  %excinfo.18 = alloca ptr, align 8
  store ptr null, ptr %excinfo.18, align 8
  %.92 = load i64, ptr %arg.layout, align 8
  %.94 = getelementptr i8, ptr %arg.layout, i64 16
  %.95 = load i64, ptr %.94, align 8
  %.105.idx = shl i64 %.92, 6
  %.105 = getelementptr i8, ptr %arg.work, i64 %.105.idx
  %.108.idx = mul i64 %.92, 72
  %.108 = getelementptr i8, ptr %arg.work, i64 %.108.idx
  %.idx = mul i64 %.92, 80
  %0 = getelementptr i8, ptr %arg.work, i64 %.idx
  %.112 = getelementptr i8, ptr %0, i64 8
  %.idx164 = mul i64 %.92, 88
  %1 = getelementptr i8, ptr %arg.work, i64 %.idx164
  %.125 = getelementptr i8, ptr %1, i64 8
  %.idx165 = mul i64 %.92, 96
  %2 = getelementptr i8, ptr %arg.work, i64 %.idx165
  %.129 = getelementptr i8, ptr %2, i64 8
  %.139.idx = shl i64 %arg.blocks, 5
  %.139 = getelementptr i8, ptr %.129, i64 %.139.idx
  %.146.idx = shl i64 %arg.blocks, 4
  %.146 = getelementptr i8, ptr %.139, i64 %.146.idx
  %.151 = getelementptr double, ptr %.146, i64 %.95
  %.157 = getelementptr i8, ptr %arg.layout, i64 24
  %.158 = load i64, ptr %.157, align 8
  %3 = getelementptr double, ptr %.151, i64 %.95
  %4 = getelementptr i8, ptr %3, i64 8
  %.161 = getelementptr double, ptr %4, i64 %.158
  %.166 = getelementptr i8, ptr %arg.layout, i64 8
  %.167 = load i64, ptr %.166, align 8
  %5 = getelementptr double, ptr %.161, i64 %.167
  %.170 = getelementptr i8, ptr %5, i64 8
  %.175 = getelementptr i8, ptr %arg.layout, i64 256
  %.176 = load i64, ptr %.175, align 8
  %.178 = getelementptr double, ptr %.170, i64 %.176
  %6 = getelementptr double, ptr %arg.edges, i64 %arg.edge_count
  %.185 = getelementptr i8, ptr %6, i64 -8
  %.186 = load double, ptr %.185, align 8
  %.192 = load i64, ptr %arg.counts, align 8
  %.284270.not = icmp slt i64 %arg.max_steps, 1
  br i1 %.284270.not, label %B2754, label %B672.if.lr.ph

B672.if.lr.ph:
  %.424 = getelementptr i8, ptr %arg.state, i64 8
  %.566 = getelementptr i8, ptr %arg.counts, i64 32
  %.576 = getelementptr i8, ptr %arg.method, i64 1344
  %.587 = getelementptr i32, ptr %arg.lu_start, i64 %arg.blocks
  %.650 = getelementptr i8, ptr %arg.counts, i64 8
  %.712 = getelementptr i8, ptr %arg.counts, i64 24
  %.722.idx = mul i64 %.92, 56
  %.722 = getelementptr i8, ptr %arg.work, i64 %.722.idx
  %.779 = getelementptr i8, ptr %arg.settings, i64 8
  %.1184 = getelementptr i8, ptr %arg.state, i64 16
  %.1187 = getelementptr i8, ptr %arg.method, i64 1352
  %.1219 = icmp sgt i64 %arg.most_recorded, 0
  %.1222 = add nsw i64 %.92, 3
  %.1273 = getelementptr i8, ptr %arg.counts, i64 40
  %.1503 = getelementptr i8, ptr %arg.settings, i64 16
  %.860 = getelementptr i8, ptr %arg.counts, i64 16
  %.868 = getelementptr i8, ptr %arg.method, i64 1352
  %.909 = getelementptr i8, ptr %arg.settings, i64 24
  %7 = add i64 %arg.edge_count, -1
  br label %B672.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B688 ], [ 0, %B1748 ], [ 0, %B2754 ], [ %.1545, %B2622.endif.if ], [ %.1513, %B2622.if ], [ %.491, %B818.endif.if ], [ %.545, %B860.if ], [ %.598, %B966.endif.if ], [ %.629, %B966.endif.endif.if ], [ %.691, %B1176.if ], [ %.731, %B1176.endif.if ], [ %.758, %B1176.endif.endif.if ], [ %.794, %B1176.endif.endif.endif.endif.if ], [ %.827, %B1176.endif.endif.endif.endif.endif.if ], [ %.876, %B1570.if ], [ %.1149, %B1942.if ], [ %.1195, %B2156.if ], [ %.1246, %B2248.if ], [ %.1288, %B2436.if ], [ 0, %B2494.endif.endif.endif ], [ %.1416, %B2494.if ], [ %.1458, %B2494.endif.endif.if ]
  ret i32 %common.ret.op

B688:
  store i64 1, ptr %retptr, align 8
  br label %common.ret

B706:
  %.422 = load double, ptr %arg.state, align 8
  %.425 = load double, ptr %.424, align 8
  %.434 = fsub contract double %.186, %.422
  %.439 = fmul contract double %.434, 0x3FEFFFFFFF768FA1
  %.441 = fcmp contract oge double %.425, %.439
  br i1 %.441, label %B856, label %B800

B800:
  %.470 = fmul contract double %.434, 5.000000e-01
  %.472 = fcmp contract ogt double %.425, %.470
  br i1 %.472, label %B818, label %B856

B818:
  store double 0.000000e+00, ptr %.485, align 8
  %.491 = call i32 @numba.21(ptr nonnull %.485, ptr nonnull %excinfo.1, double %.425, double %.470)
  switch i32 %.491, label %B818.endif.if [
    i32 -2, label %B818.endif.endif
    i32 0, label %B818.endif.endif
  ]

B856:
  %h.3.1 = phi double [ %.425, %B800 ], [ %.501, %B818.endif.endif ], [ %.434, %B706 ]
  br i1 %fresh.3.0273, label %B966, label %B860

B860:
  store ptr null, ptr %.541, align 8
  %.545 = call i32 @linearise.22(ptr nonnull %.541, ptr nonnull %excinfo.2, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.pos, ptr %arg.numbers, ptr %arg.drive_rows, ptr %arg.drive_columns, double %.422, ptr %arg.y, ptr %arg.Y, ptr %.151, ptr %.161, ptr %.125, ptr %.170, ptr %.178)
  switch i32 %.545, label %B860.if [
    i32 -2, label %B860.endif
    i32 0, label %B860.endif
  ]

B966:
  %.577 = load double, ptr %.576, align 8
  %.579 = fmul contract double %h.3.1, %.577
  %.583 = fdiv contract double 1.000000e+00, %.579
  %.588 = load i32, ptr %.587, align 4
  store ptr null, ptr %.594, align 8
  %.598 = call i32 @lu_fill.23(ptr nonnull %.594, ptr nonnull %excinfo.3, i64 %.92, i32 %.588, ptr %.151, ptr %arg.own, ptr %arg.mass, double %.583, ptr %.146)
  switch i32 %.598, label %B966.endif.if [
    i32 -2, label %B966.endif.endif
    i32 0, label %B966.endif.endif
  ]

B1176:
  store ptr null, ptr %.687, align 8
  %.691 = call i32 @solve_stages.24(ptr nonnull %.687, ptr nonnull %excinfo.5, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, i64 %arg.blocks, ptr %arg.slots, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %arg.mass, ptr %arg.method, double %.422, double %h.3.1, ptr %arg.y, ptr %arg.Y, ptr %.125, ptr %.146, ptr %arg.work, ptr %.105, i64 0, ptr %.108, ptr %.112, ptr %.139, ptr %.170, ptr %.178)
  switch i32 %.691, label %B1176.if [
    i32 -2, label %B1176.endif
    i32 0, label %B1176.endif
  ]

B1558:
  %error.2.1 = phi double [ %.837, %B1176.endif.endif.endif.endif.endif.endif ], [ 0x7FF0000000000000, %B966.endif.endif.endif ]
  %.851 = fcmp contract ugt double %error.2.1, 1.000000e+00
  br i1 %.851, label %B1570, label %B1770

B1570:
  %.861 = load i64, ptr %.860, align 8
  %.862 = add nsw i64 %.861, 1
  store i64 %.862, ptr %.860, align 8
  %.869 = load double, ptr %.868, align 8
  store double 0.000000e+00, ptr %.872, align 8
  %.876 = call i32 @step_factor.25(ptr nonnull %.872, ptr nonnull %excinfo.10, double %error.2.1, double 1.000000e+00, double %.869, ptr %arg.settings)
  switch i32 %.876, label %B1570.if [
    i32 -2, label %B1570.endif
    i32 0, label %B1570.endif
  ]

B1748:
  store i64 2, ptr %retptr, align 8
  br label %common.ret

B1770:
  %.1024 = fadd contract double %.422, %h.3.1
  %until.2.1 = select i1 %.441, double %.186, double %.1024
  %.1036 = load i64, ptr %arg.counts, align 8
  %.1046 = icmp slt i64 %.1036, %arg.edge_count
  br i1 %.1046, label %B1826, label %B1908

B1826:
  %.1057 = getelementptr double, ptr %arg.edges, i64 %.1036
  %.1058 = load double, ptr %.1057, align 8
  %.1062 = fmul contract double %until.2.1, 0x3FF0000000000005
  %.1063 = fcmp contract ugt double %.1058, %.1062
  br i1 %.1063, label %B1908, label %B1856

B1856:
  %stop.2.1 = phi i64 [ %.1069, %B1878 ], [ %.1036, %B1826 ]
  %exitcond.not = icmp eq i64 %stop.2.1, %7
  br i1 %exitcond.not, label %B1908, label %B1878

B1878:
  %.1069 = add nsw i64 %stop.2.1, 1
  %.1090 = getelementptr double, ptr %arg.edges, i64 %.1069
  %.1091 = load double, ptr %.1090, align 8
  %.1096 = fcmp contract ugt double %.1091, %.1062
  br i1 %.1096, label %B1908, label %B1856

B1908:
  %stop.3.2 = phi i64 [ %.1036, %B1826 ], [ %.1036, %B1770 ], [ %arg.edge_count, %B1856 ], [ %.1069, %B1878 ]
  %.1113 = icmp sgt i64 %stop.3.2, %.1036
  br i1 %.1113, label %B1942, label %B2156

B1942:
  %.1120 = getelementptr double, ptr %arg.edges, i64 %.1036
  %.1125 = sub nsw i64 %stop.3.2, %.1036
  %.1130 = sub nsw i64 %.1036, %.192
  %.1132 = mul nsw i64 %.1130, %.92
  %.1134 = getelementptr double, ptr %arg.outputs, i64 %.1132
  store ptr null, ptr %.1145, align 8
  %.1149 = call i32 @dense_output.26(ptr nonnull %.1145, ptr nonnull %excinfo.11, i64 %.92, ptr %arg.y, ptr %.112, ptr %arg.work, ptr %arg.method, double %.422, double %until.2.1, ptr %.1120, i64 %.1125, ptr %.1134, ptr %.108, ptr %.129, ptr %.139)
  switch i32 %.1149, label %B1942.if [
    i32 -2, label %B1942.endif
    i32 0, label %B1942.endif
  ]

B2156:
  %.1185 = load double, ptr %.1184, align 8
  %.1188 = load double, ptr %.1187, align 8
  store double 0.000000e+00, ptr %.1191, align 8
  %.1195 = call i32 @step_factor.25(ptr nonnull %.1191, ptr nonnull %excinfo.12, double %error.2.1, double %.1185, double %.1188, ptr %arg.settings)
  %.1205 = load double, ptr %.1191, align 8
  switch i32 %.1195, label %B2156.if [
    i32 -2, label %B2156.endif
    i32 0, label %B2156.endif
  ]

B2248:
  %.1224 = mul nsw i64 %recorded.2.0272, %.1222
  %.1226 = getelementptr double, ptr %arg.record, i64 %.1224
  store double %.422, ptr %.1226, align 8
  %.1233 = getelementptr i8, ptr %.1226, i64 8
  store double %h.3.1, ptr %.1233, align 8
  %.1236 = getelementptr i8, ptr %.1226, i64 16
  store double %until.2.1, ptr %.1236, align 8
  %.1239 = getelementptr i8, ptr %.1226, i64 24
  store ptr null, ptr %.1242, align 8
  %.1246 = call i32 @copy.27(ptr nonnull %.1242, ptr nonnull %excinfo.13, i64 %.92, ptr %arg.y, ptr %.1239)
  switch i32 %.1246, label %B2248.if [
    i32 -2, label %B2248.endif
    i32 0, label %B2248.endif
  ]

B2436:
  %recorded.4.1 = phi i64 [ %.1267, %B2248.endif ], [ %recorded.2.0272, %B2156.endif ]
  store ptr null, ptr %.1284, align 8
  %.1288 = call i32 @copy.27(ptr nonnull %.1284, ptr nonnull %excinfo.14, i64 %.92, ptr %.112, ptr %arg.y)
  switch i32 %.1288, label %B2436.if [
    i32 -2, label %B2436.endif
    i32 0, label %B2436.endif
  ]

B2494:
  store double 0.000000e+00, ptr %.1410, align 8
  %.1416 = call i32 @numba.28(ptr nonnull %.1410, ptr nonnull %excinfo.15, double %.425, double %h.3.1)
  %.1426 = load double, ptr %.1410, align 8
  switch i32 %.1416, label %B2494.if [
    i32 -2, label %B2494.endif
    i32 0, label %B2494.endif
  ]

B2622:
  %.1497 = fmul contract double %h.3.1, %.1205
  %.1504 = load double, ptr %.1503, align 8
  store double 0.000000e+00, ptr %.1507, align 8
  %.1513 = call i32 @numba.21(ptr nonnull %.1507, ptr nonnull %excinfo.17, double %.1497, double %.1504)
  switch i32 %.1513, label %B2622.if [
    i32 -2, label %B2622.endif
    i32 0, label %B2622.endif
  ]

B2754:
  store i64 1, ptr %retptr, align 8
  br label %common.ret

B2755:
  %recorded.3.1 = phi i64 [ %recorded.4.1, %B2622.endif.endif ], [ %recorded.2.0272, %B1570.endif ]
  %.284 = icmp sgt i64 %.228.0271, 1
  br i1 %.284, label %B672.if, label %B2754

B672.if:
  %fresh.3.0273 = phi i1 [ false, %B672.if.lr.ph ], [ %.851, %B2755 ]
  %recorded.2.0272 = phi i64 [ 0, %B672.if.lr.ph ], [ %recorded.3.1, %B2755 ]
  %.228.0271 = phi i64 [ %arg.max_steps, %B672.if.lr.ph ], [ %.293, %B2755 ]
  %.293 = add nsw i64 %.228.0271, -1
  %.324 = icmp eq i64 %recorded.2.0272, %arg.most_recorded
  br i1 %.324, label %B688, label %B706

B818.endif.if:
  %.499 = icmp sgt i32 %.491, 0
  %.492 = load ptr, ptr %excinfo.1, align 8
  %.500 = select i1 %.499, ptr %.492, ptr undef
  store ptr %.500, ptr %excinfo, align 8
  br label %common.ret

B818.endif.endif:
  %.501 = load double, ptr %.485, align 8
  br label %B856

B860.if:
  %.553 = icmp sgt i32 %.545, 0
  %.546 = load ptr, ptr %excinfo.2, align 8
  %.554 = select i1 %.553, ptr %.546, ptr undef
  store ptr %.554, ptr %excinfo, align 8
  br label %common.ret

B860.endif:
  %.567 = load i64, ptr %.566, align 8
  %.568 = add nsw i64 %.567, 1
  store i64 %.568, ptr %.566, align 8
  br label %B966

B966.endif.if:
  %.606 = icmp sgt i32 %.598, 0
  %.599 = load ptr, ptr %excinfo.3, align 8
  %.607 = select i1 %.606, ptr %.599, ptr undef
  store ptr %.607, ptr %excinfo, align 8
  br label %common.ret

B966.endif.endif:
  store i64 0, ptr %.625, align 8
  %.629 = call i32 @lu_factor.17(ptr nonnull %.625, ptr nonnull %excinfo.4, i64 %arg.blocks, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %.146, ptr %.129)
  switch i32 %.629, label %B966.endif.endif.if [
    i32 -2, label %B966.endif.endif.endif
    i32 0, label %B966.endif.endif.endif
  ]

B966.endif.endif.if:
  %.637 = icmp sgt i32 %.629, 0
  %.630 = load ptr, ptr %excinfo.4, align 8
  %.638 = select i1 %.637, ptr %.630, ptr undef
  store ptr %.638, ptr %excinfo, align 8
  br label %common.ret

B966.endif.endif.endif:
  %.639 = load i64, ptr %.625, align 8
  %.651 = load i64, ptr %.650, align 8
  %.652 = add nsw i64 %.651, 1
  store i64 %.652, ptr %.650, align 8
  %.659 = icmp eq i64 %.639, 0
  br i1 %.659, label %B1176, label %B1558

B1176.if:
  %.699 = icmp sgt i32 %.691, 0
  %.692 = load ptr, ptr %excinfo.5, align 8
  %.700 = select i1 %.699, ptr %.692, ptr undef
  store ptr %.700, ptr %excinfo, align 8
  br label %common.ret

B1176.endif:
  %.713 = load i64, ptr %.712, align 8
  %.714 = add nsw i64 %.713, 8
  store i64 %.714, ptr %.712, align 8
  store ptr null, ptr %.727, align 8
  %.731 = call i32 @copy.27(ptr nonnull %.727, ptr nonnull %excinfo.6, i64 %.92, ptr %.105, ptr %.112)
  switch i32 %.731, label %B1176.endif.if [
    i32 -2, label %B1176.endif.endif
    i32 0, label %B1176.endif.endif
  ]

B1176.endif.if:
  %.739 = icmp sgt i32 %.731, 0
  %.732 = load ptr, ptr %excinfo.6, align 8
  %.740 = select i1 %.739, ptr %.732, ptr undef
  store ptr %.740, ptr %excinfo, align 8
  br label %common.ret

B1176.endif.endif:
  store ptr null, ptr %.754, align 8
  %.758 = call i32 @add_scaled.29(ptr nonnull %.754, ptr nonnull %excinfo.7, i64 %.92, double 1.000000e+00, ptr %.722, ptr %.112)
  switch i32 %.758, label %B1176.endif.endif.if [
    i32 -2, label %B1176.endif.endif.endif
    i32 0, label %B1176.endif.endif.endif
  ]

B1176.endif.endif.if:
  %.766 = icmp sgt i32 %.758, 0
  %.759 = load ptr, ptr %excinfo.7, align 8
  %.767 = select i1 %.766, ptr %.759, ptr undef
  store ptr %.767, ptr %excinfo, align 8
  br label %common.ret

B1176.endif.endif.endif:
  %.780 = load double, ptr %.779, align 8
  %.785 = fdiv contract double %h.3.1, %.780
  store double 0.000000e+00, ptr %.788, align 8
  %.794 = call i32 @numba.21(ptr nonnull %.788, ptr nonnull %excinfo.8, double 1.000000e+00, double %.785)
  switch i32 %.794, label %B1176.endif.endif.endif.endif.if [
    i32 -2, label %B1176.endif.endif.endif.endif.endif
    i32 0, label %B1176.endif.endif.endif.endif.endif
  ]

B1176.endif.endif.endif.endif.if:
  %.802 = icmp sgt i32 %.794, 0
  %.795 = load ptr, ptr %excinfo.8, align 8
  %.803 = select i1 %.802, ptr %.795, ptr undef
  store ptr %.803, ptr %excinfo, align 8
  br label %common.ret

B1176.endif.endif.endif.endif.endif:
  %.804 = load double, ptr %.788, align 8
  %.817 = load double, ptr %arg.settings, align 8
  store double 0.000000e+00, ptr %.823, align 8
  %.827 = call i32 @step_error.30(ptr nonnull %.823, ptr nonnull %excinfo.9, i64 %.92, i64 %arg.tested, ptr %arg.y, ptr %.112, ptr %.722, ptr %arg.powers, double %.804, double %.817)
  switch i32 %.827, label %B1176.endif.endif.endif.endif.endif.if [
    i32 -2, label %B1176.endif.endif.endif.endif.endif.endif
    i32 0, label %B1176.endif.endif.endif.endif.endif.endif
  ]

B1176.endif.endif.endif.endif.endif.if:
  %.835 = icmp sgt i32 %.827, 0
  %.828 = load ptr, ptr %excinfo.9, align 8
  %.836 = select i1 %.835, ptr %.828, ptr undef
  store ptr %.836, ptr %excinfo, align 8
  br label %common.ret

B1176.endif.endif.endif.endif.endif.endif:
  %.837 = load double, ptr %.823, align 8
  br label %B1558

B1570.if:
  %.884 = icmp sgt i32 %.876, 0
  %.877 = load ptr, ptr %excinfo.10, align 8
  %.885 = select i1 %.884, ptr %.877, ptr undef
  store ptr %.885, ptr %excinfo, align 8
  br label %common.ret

B1570.endif:
  %.886 = load double, ptr %.872, align 8
  %.899 = fmul contract double %h.3.1, %.886
  store double %.899, ptr %.424, align 8
  %.910 = load double, ptr %.909, align 8
  %.911 = fcmp contract olt double %.899, %.910
  br i1 %.911, label %B1748, label %B2755

B1942.if:
  %.1157 = icmp sgt i32 %.1149, 0
  %.1150 = load ptr, ptr %excinfo.11, align 8
  %.1158 = select i1 %.1157, ptr %.1150, ptr undef
  store ptr %.1158, ptr %excinfo, align 8
  br label %common.ret

B1942.endif:
  store i64 %stop.3.2, ptr %arg.counts, align 8
  br label %B2156

B2156.if:
  %.1203 = icmp sgt i32 %.1195, 0
  %.1196 = load ptr, ptr %excinfo.12, align 8
  %.1204 = select i1 %.1203, ptr %.1196, ptr undef
  store ptr %.1204, ptr %excinfo, align 8
  br label %common.ret

B2156.endif:
  br i1 %.1219, label %B2248, label %B2436

B2248.if:
  %.1254 = icmp sgt i32 %.1246, 0
  %.1247 = load ptr, ptr %excinfo.13, align 8
  %.1255 = select i1 %.1254, ptr %.1247, ptr undef
  store ptr %.1255, ptr %excinfo, align 8
  br label %common.ret

B2248.endif:
  %.1267 = add nsw i64 %recorded.2.0272, 1
  store i64 %.1267, ptr %.1273, align 8
  br label %B2436

B2436.if:
  %.1296 = icmp sgt i32 %.1288, 0
  %.1289 = load ptr, ptr %excinfo.14, align 8
  %.1297 = select i1 %.1296, ptr %.1289, ptr undef
  store ptr %.1297, ptr %excinfo, align 8
  br label %common.ret

B2436.endif:
  store double %until.2.1, ptr %arg.state, align 8
  br i1 %.441, label %B2494, label %B2622

B2494.if:
  %.1424 = icmp sgt i32 %.1416, 0
  %.1417 = load ptr, ptr %excinfo.15, align 8
  %.1425 = select i1 %.1424, ptr %.1417, ptr undef
  store ptr %.1425, ptr %excinfo, align 8
  br label %common.ret

B2494.endif:
  %.1441 = getelementptr i8, ptr %arg.settings, i64 32
  %.1442 = load double, ptr %.1441, align 8
  %.1448 = fdiv contract double 1.000000e+00, %.1442
  store double 0.000000e+00, ptr %.1452, align 8
  %.1458 = call i32 @numba.21(ptr nonnull %.1452, ptr nonnull %excinfo.16, double %.1205, double %.1448)
  switch i32 %.1458, label %B2494.endif.endif.if [
    i32 -2, label %B2494.endif.endif.endif
    i32 0, label %B2494.endif.endif.endif
  ]

B2494.endif.endif.if:
  %.1466 = icmp sgt i32 %.1458, 0
  %.1459 = load ptr, ptr %excinfo.16, align 8
  %.1467 = select i1 %.1466, ptr %.1459, ptr undef
  store ptr %.1467, ptr %excinfo, align 8
  br label %common.ret

B2494.endif.endif.endif:
  %.1468 = load double, ptr %.1452, align 8
  %.1480 = fmul contract double %.1426, %.1468
  store double %.1480, ptr %.424, align 8
  store i64 0, ptr %retptr, align 8
  br label %common.ret

B2622.if:
  %.1521 = icmp sgt i32 %.1513, 0
  %.1514 = load ptr, ptr %excinfo.17, align 8
  %.1522 = select i1 %.1521, ptr %.1514, ptr undef
  store ptr %.1522, ptr %excinfo, align 8
  br label %common.ret

B2622.endif:
  %.1523 = load double, ptr %.1507, align 8
  store double %.1523, ptr %.424, align 8
  store double 0.000000e+00, ptr %.1539, align 8
  %.1545 = call i32 @numba.28(ptr nonnull %.1539, ptr nonnull %excinfo.18, double %error.2.1, double 1.000000e-04)
  switch i32 %.1545, label %B2622.endif.if [
    i32 -2, label %B2622.endif.endif
    i32 0, label %B2622.endif.endif
  ]

B2622.endif.if:
  %.1553 = icmp sgt i32 %.1545, 0
  %.1546 = load ptr, ptr %excinfo.18, align 8
  %.1554 = select i1 %.1553, ptr %.1546, ptr undef
  store ptr %.1554, ptr %excinfo, align 8
  br label %common.ret

B2622.endif.endif:
  %.1555 = load double, ptr %.1539, align 8
  store double %.1555, ptr %.1184, align 8
  br label %B2755
}

define internal i32 @linearise.22(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.pos, ptr noalias %arg.numbers, ptr noalias %arg.drive_rows, ptr noalias %arg.drive_columns, double %arg.time, ptr noalias %arg.y, ptr noalias %arg.Y, ptr noalias %arg.J, ptr noalias %arg.rates, ptr noalias %arg.drift, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.42 = alloca ptr, align 8
  store ptr null, ptr %.42, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.76 = alloca ptr, align 8
  store ptr null, ptr %.76, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.103 = alloca ptr, align 8
  store ptr null, ptr %.103, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.130 = alloca ptr, align 8
  store ptr null, ptr %.130, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.34 = load i64, ptr %arg.layout, align 8
  %.36 = getelementptr i8, ptr %arg.layout, i64 16
  %.37 = load i64, ptr %.36, align 8
  store ptr null, ptr %.42, align 8
  %.46 = call i32 @copy.27(ptr nonnull %.42, ptr nonnull %excinfo.1, i64 %.34, ptr %arg.y, ptr %arg.Y)
  switch i32 %.46, label %B0.if [
    i32 -2, label %B0.endif
    i32 0, label %B0.endif
  ]

B310:
  %.280 = getelementptr i8, ptr %arg.layout, i64 24
  %.281 = load i64, ptr %.280, align 8
  %.36378.not = icmp slt i64 %.281, 1
  br i1 %.36378.not, label %B466, label %B362.if.lr.ph

B362.if.lr.ph:
  %0 = getelementptr double, ptr %arg.J, i64 %.37
  %1 = getelementptr i8, ptr %0, i64 8
  br label %B362.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B466 ], [ %.134, %B0.endif.endif.endif.if ], [ %.46, %B0.if ], [ %.80, %B0.endif.if ], [ %.107, %B0.endif.endif.if ]
  ret i32 %common.ret.op

B466:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B0.if:
  %.54 = icmp sgt i32 %.46, 0
  %.47 = load ptr, ptr %excinfo.1, align 8
  %.55 = select i1 %.54, ptr %.47, ptr undef
  store ptr %.55, ptr %excinfo, align 8
  br label %common.ret

B0.endif:
  %.69 = getelementptr i8, ptr %arg.layout, i64 8
  %.70 = load i64, ptr %.69, align 8
  %2 = getelementptr double, ptr %arg.Y, i64 %.34
  %.72 = getelementptr double, ptr %2, i64 %.70
  store double %arg.time, ptr %.72, align 8
  store ptr null, ptr %.76, align 8
  %.80 = call i32 @drive.6(ptr nonnull %.76, ptr nonnull %excinfo.2, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.local, ptr %arg.out)
  switch i32 %.80, label %B0.endif.if [
    i32 -2, label %B0.endif.endif
    i32 0, label %B0.endif.endif
  ]

B0.endif.if:
  %.88 = icmp sgt i32 %.80, 0
  %.81 = load ptr, ptr %excinfo.2, align 8
  %.89 = select i1 %.88, ptr %.81, ptr undef
  store ptr %.89, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif:
  store ptr null, ptr %.103, align 8
  %.107 = call i32 @jacobian.4(ptr nonnull %.103, ptr nonnull %excinfo.3, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.pos, ptr %arg.numbers, ptr %arg.Y, ptr %arg.J, ptr %arg.local, ptr %arg.out)
  switch i32 %.107, label %B0.endif.endif.if [
    i32 -2, label %B0.endif.endif.endif
    i32 0, label %B0.endif.endif.endif
  ]

B0.endif.endif.if:
  %.115 = icmp sgt i32 %.107, 0
  %.108 = load ptr, ptr %excinfo.3, align 8
  %.116 = select i1 %.115, ptr %.108, ptr undef
  store ptr %.116, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif:
  store ptr null, ptr %.130, align 8
  %.134 = call i32 @drive_rates.7(ptr nonnull %.130, ptr nonnull %excinfo.4, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.rates, ptr %arg.local, ptr %arg.out)
  switch i32 %.134, label %B0.endif.endif.endif.if [
    i32 -2, label %B0.endif.endif.endif.endif
    i32 0, label %B0.endif.endif.endif.endif
  ]

B0.endif.endif.endif.if:
  %.142 = icmp sgt i32 %.134, 0
  %.135 = load ptr, ptr %excinfo.4, align 8
  %.143 = select i1 %.142, ptr %.135, ptr undef
  store ptr %.143, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endif:
  %.23375.not = icmp slt i64 %.34, 1
  br i1 %.23375.not, label %B310, label %B294.if.preheader

B294.if.preheader:
  %3 = shl nuw i64 %.34, 3
  call void @llvm.memset.p0.i64(ptr align 8 %arg.drift, i8 0, i64 %3, i1 false)
  br label %B310

B362.if:
  %.307.079 = phi i64 [ 0, %B362.if.lr.ph ], [ %.376, %B362.if ]
  %.376 = add nuw nsw i64 %.307.079, 1
  %.402 = getelementptr i32, ptr %arg.drive_rows, i64 %.307.079
  %.403 = load i32, ptr %.402, align 4
  %.405 = sext i32 %.403 to i64
  %.406 = getelementptr double, ptr %arg.drift, i64 %.405
  %.407 = load double, ptr %.406, align 8
  %.412 = getelementptr double, ptr %1, i64 %.307.079
  %.413 = load double, ptr %.412, align 8
  %.415 = getelementptr i32, ptr %arg.drive_columns, i64 %.307.079
  %.416 = load i32, ptr %.415, align 4
  %.418 = sext i32 %.416 to i64
  %.419 = getelementptr double, ptr %arg.rates, i64 %.418
  %.420 = load double, ptr %.419, align 8
  %.421 = fmul contract double %.413, %.420
  %.422 = fadd contract double %.407, %.421
  store double %.422, ptr %.406, align 8
  %exitcond.not = icmp eq i64 %.376, %.281
  br i1 %exitcond.not, label %B466, label %B362.if
}

define internal i32 @solve_stages.24(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, i64 %arg.blocks, ptr noalias %arg.slots, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.mass, ptr noalias %arg.method, double %arg.time, double %arg.h, ptr noalias %arg.y, ptr noalias %arg.Y, ptr noalias %arg.drift, ptr noalias %arg.lu, ptr noalias %arg.stages, ptr noalias %arg.place_, i64 %arg.stride, ptr noalias %arg.right, ptr noalias %arg.after, ptr noalias %arg.x, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.226 = alloca ptr, align 8
  store ptr null, ptr %.226, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.381 = alloca ptr, align 8
  store ptr null, ptr %.381, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.456 = alloca ptr, align 8
  store ptr null, ptr %.456, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.485 = alloca ptr, align 8
  store ptr null, ptr %.485, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.537 = alloca ptr, align 8
  store ptr null, ptr %.537, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.571 = alloca ptr, align 8
  store ptr null, ptr %.571, align 8
  %excinfo.7 = alloca ptr, align 8
  store ptr null, ptr %excinfo.7, align 8
  %.608 = alloca ptr, align 8
  store ptr null, ptr %.608, align 8
  %excinfo.8 = alloca ptr, align 8
  store ptr null, ptr %excinfo.8, align 8
  %.650 = alloca ptr, align 8
  store ptr null, ptr %.650, align 8
  %excinfo.9 = alloca ptr, align 8
  store ptr null, ptr %excinfo.9, align 8
  %.696 = alloca ptr, align 8
  store ptr null, ptr %.696, align 8
  %excinfo.10 = alloca ptr, align 8
  store ptr null, ptr %excinfo.10, align 8
  %.84 = load i64, ptr %arg.layout, align 8
  %.521 = getelementptr i8, ptr %arg.layout, i64 8
  %0 = getelementptr double, ptr %arg.Y, i64 %.84
  br label %B72.if

B136:
  store ptr null, ptr %.226, align 8
  %.230 = call i32 @copy.27(ptr nonnull %.226, ptr nonnull %excinfo.1, i64 %.84, ptr %arg.y, ptr %arg.place_)
  switch i32 %.230, label %B136.if [
    i32 -2, label %B136.endif
    i32 0, label %B136.endif
  ]

B302:
  %.449 = add nsw i64 %.111.0122, -1
  %.451 = mul nsw i64 %.449, %.84
  %.453 = getelementptr double, ptr %arg.stages, i64 %.451
  store ptr null, ptr %.456, align 8
  %.460 = call i32 @add_scaled.29(ptr nonnull %.456, ptr nonnull %excinfo.4, i64 %.84, double 1.000000e+00, ptr %.453, ptr %arg.place_)
  switch i32 %.460, label %B388.if [
    i32 -2, label %B464
    i32 0, label %B464
  ]

B464:
  store ptr null, ptr %.485, align 8
  %.489 = call i32 @copy.27(ptr nonnull %.485, ptr nonnull %excinfo.5, i64 %.84, ptr %arg.place_, ptr %arg.Y)
  switch i32 %.489, label %B464.if [
    i32 -2, label %B464.endif
    i32 0, label %B464.endif
  ]

B810:
  store ptr null, ptr %.650, align 8
  %.654 = call i32 @add_scaled.29(ptr nonnull %.650, ptr nonnull %excinfo.9, i64 %.84, double %.638, ptr %arg.drift, ptr %arg.right)
  switch i32 %.654, label %B810.if [
    i32 -2, label %B846
    i32 0, label %B846
  ]

B846:
  %.681 = mul nsw i64 %.111.0122, %.84
  %.685 = getelementptr double, ptr %arg.stages, i64 %.681
  store ptr null, ptr %.696, align 8
  %.700 = call i32 @lu_solve.19(ptr nonnull %.696, ptr nonnull %excinfo.10, i64 %.84, ptr %arg.slots, i64 %arg.blocks, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %arg.lu, ptr %arg.right, ptr %.685, ptr %arg.x)
  switch i32 %.700, label %B846.if [
    i32 -2, label %B846.endif
    i32 0, label %B846.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ 0, %B936 ], [ %.700, %B846.if ], [ %.654, %B810.if ], [ %.612, %B464.endif.endif.endif.if ], [ %.230, %B136.if ], [ %.385, %B202.if ], [ %.460, %B388.if ], [ %.489, %B464.if ], [ %.541, %B464.endif.if ], [ %.575, %B464.endif.endif.if ]
  ret i32 %common.ret.op

B936:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B72.if:
  %.111.0122 = phi i64 [ 0, %entry ], [ %.183, %B846.endif ]
  %.183 = add nuw nsw i64 %.111.0122, 1
  %.220 = icmp samesign ult i64 %.111.0122, 6
  br i1 %.220, label %B136, label %B302

B136.if:
  %.238 = icmp sgt i32 %.230, 0
  %.231 = load ptr, ptr %excinfo.1, align 8
  %.239 = select i1 %.238, ptr %.231, ptr undef
  store ptr %.239, ptr %excinfo, align 8
  br label %common.ret

B136.endif:
  %.330119.not = icmp eq i64 %.111.0122, 0
  br i1 %.330119.not, label %B464, label %B200.if.lr.ph

B200.if.lr.ph:
  %.idx103 = shl nuw nsw i64 %.111.0122, 6
  %1 = getelementptr i8, ptr %arg.method, i64 %.idx103
  br label %B200.if

B200.if:
  %.274.0120 = phi i64 [ 0, %B200.if.lr.ph ], [ %.343, %B202.endif ]
  %.373 = getelementptr double, ptr %1, i64 %.274.0120
  %.374 = load double, ptr %.373, align 8
  %.376 = mul nsw i64 %.274.0120, %.84
  %.378 = getelementptr double, ptr %arg.stages, i64 %.376
  store ptr null, ptr %.381, align 8
  %.385 = call i32 @add_scaled.29(ptr nonnull %.381, ptr nonnull %excinfo.2, i64 %.84, double %.374, ptr %.378, ptr %arg.place_)
  switch i32 %.385, label %B202.if [
    i32 -2, label %B202.endif
    i32 0, label %B202.endif
  ]

B202.if:
  %.393 = icmp sgt i32 %.385, 0
  %.386 = load ptr, ptr %excinfo.2, align 8
  %.394 = select i1 %.393, ptr %.386, ptr undef
  store ptr %.394, ptr %excinfo, align 8
  br label %common.ret

B202.endif:
  %.343 = add nuw nsw i64 %.274.0120, 1
  %exitcond.not = icmp eq i64 %.343, %.111.0122
  br i1 %exitcond.not, label %B464, label %B200.if

B388.if:
  %.468 = icmp sgt i32 %.460, 0
  %.461 = load ptr, ptr %excinfo.4, align 8
  %.469 = select i1 %.468, ptr %.461, ptr undef
  store ptr %.469, ptr %excinfo, align 8
  br label %common.ret

B464.if:
  %.497 = icmp sgt i32 %.489, 0
  %.490 = load ptr, ptr %excinfo.5, align 8
  %.498 = select i1 %.497, ptr %.490, ptr undef
  store ptr %.498, ptr %excinfo, align 8
  br label %common.ret

B464.endif:
  %2 = getelementptr double, ptr %arg.method, i64 %.111.0122
  %.514 = getelementptr i8, ptr %2, i64 1024
  %.515 = load double, ptr %.514, align 8
  %.517 = fmul contract double %arg.h, %.515
  %.519 = fadd contract double %arg.time, %.517
  %.522 = load i64, ptr %.521, align 8
  %.526 = getelementptr double, ptr %0, i64 %.522
  store double %.519, ptr %.526, align 8
  store ptr null, ptr %.537, align 8
  %.541 = call i32 @drive.6(ptr nonnull %.537, ptr nonnull %excinfo.6, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.local, ptr %arg.out)
  switch i32 %.541, label %B464.endif.if [
    i32 -2, label %B464.endif.endif
    i32 0, label %B464.endif.endif
  ]

B464.endif.if:
  %.549 = icmp sgt i32 %.541, 0
  %.542 = load ptr, ptr %excinfo.6, align 8
  %.550 = select i1 %.549, ptr %.542, ptr undef
  store ptr %.550, ptr %excinfo, align 8
  br label %common.ret

B464.endif.endif:
  store ptr null, ptr %.571, align 8
  %.575 = call i32 @residual.0(ptr nonnull %.571, ptr nonnull %excinfo.7, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.right, ptr %arg.local, ptr %arg.out)
  switch i32 %.575, label %B464.endif.endif.if [
    i32 -2, label %B464.endif.endif.endif
    i32 0, label %B464.endif.endif.endif
  ]

B464.endif.endif.if:
  %.583 = icmp sgt i32 %.575, 0
  %.576 = load ptr, ptr %excinfo.7, align 8
  %.584 = select i1 %.583, ptr %.576, ptr undef
  store ptr %.584, ptr %excinfo, align 8
  br label %common.ret

B464.endif.endif.endif:
  %.idx = shl i64 %.111.0122, 6
  %3 = getelementptr i8, ptr %arg.method, i64 %.idx
  %.600 = getelementptr i8, ptr %3, i64 512
  store ptr null, ptr %.608, align 8
  %.612 = call i32 @combine.31(ptr nonnull %.608, ptr nonnull %excinfo.8, i64 %.84, i64 %.111.0122, ptr %.600, double %arg.h, ptr %arg.mass, ptr %arg.stages, ptr %arg.right, ptr %arg.after)
  switch i32 %.612, label %B464.endif.endif.endif.if [
    i32 -2, label %B464.endif.endif.endif.endif
    i32 0, label %B464.endif.endif.endif.endif
  ]

B464.endif.endif.endif.if:
  %.620 = icmp sgt i32 %.612, 0
  %.613 = load ptr, ptr %excinfo.8, align 8
  %.621 = select i1 %.620, ptr %.613, ptr undef
  store ptr %.621, ptr %excinfo, align 8
  br label %common.ret

B464.endif.endif.endif.endif:
  %.635 = getelementptr i8, ptr %2, i64 1088
  %.636 = load double, ptr %.635, align 8
  %.638 = fmul contract double %arg.h, %.636
  %.643 = fcmp contract une double %.638, 0.000000e+00
  br i1 %.643, label %B810, label %B846

B810.if:
  %.662 = icmp sgt i32 %.654, 0
  %.655 = load ptr, ptr %excinfo.9, align 8
  %.663 = select i1 %.662, ptr %.655, ptr undef
  store ptr %.663, ptr %excinfo, align 8
  br label %common.ret

B846.if:
  %.708 = icmp sgt i32 %.700, 0
  %.701 = load ptr, ptr %excinfo.10, align 8
  %.709 = select i1 %.708, ptr %.701, ptr undef
  store ptr %.709, ptr %excinfo, align 8
  br label %common.ret

B846.endif:
  %exitcond145.not = icmp eq i64 %.183, 8
  br i1 %exitcond145.not, label %B936, label %B72.if
}

define internal i32 @step_factor.25(ptr noalias %retptr, ptr noalias %excinfo, double %arg.error, double %arg.before, double %arg.order, ptr noalias %arg.settings) noinline {
entry:
  %.36 = alloca double, align 8
  store double 0.000000e+00, ptr %.36, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.132 = alloca double, align 8
  store double 0.000000e+00, ptr %.132, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.162 = alloca double, align 8
  store double 0.000000e+00, ptr %.162, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.17 = fsub contract double %arg.error, %arg.error
  %.18 = fcmp contract ord double %.17, 0.000000e+00
  br i1 %.18, label %B70, label %B44

common.ret:
  %common.ret.op = phi i32 [ 0, %B44 ], [ %.138, %B250.if ], [ %.42, %B70.if ], [ 0, %B250.endif.endif ], [ %.168, %B250.endif.if ]
  ret i32 %common.ret.op

B44:
  %.27 = getelementptr i8, ptr %arg.settings, i64 48
  %.28 = load double, ptr %.27, align 8
  store double %.28, ptr %retptr, align 8
  br label %common.ret

B70:
  store double 0.000000e+00, ptr %.36, align 8
  %.42 = call i32 @numba.28(ptr nonnull %.36, ptr nonnull %excinfo.1, double %arg.error, double 1.000000e-10)
  %.52 = load double, ptr %.36, align 8
  switch i32 %.42, label %B70.if [
    i32 -2, label %B70.endif
    i32 0, label %B70.endif
  ]

B114:
  %.75 = getelementptr i8, ptr %arg.settings, i64 32
  %.76 = load double, ptr %.75, align 8
  %.81 = fdiv contract double -1.000000e+00, %arg.order
  %.85 = call contract double @llvm.pow.f64(double %.52, double %.81)
  %.88 = fmul contract double %.85, %.76
  br label %B250

B160:
  %.94 = getelementptr i8, ptr %arg.settings, i64 56
  %.95 = load double, ptr %.94, align 8
  %.97 = getelementptr i8, ptr %arg.settings, i64 32
  %.98 = load double, ptr %.97, align 8
  %.103 = fdiv contract double 1.000000e+00, %arg.order
  %.106 = fsub contract double %.95, %.103
  %.108 = call contract double @llvm.pow.f64(double %.52, double %.106)
  %.111 = fmul contract double %.98, %.108
  %.112 = fneg contract double %.95
  %.114 = call contract double @llvm.pow.f64(double %arg.before, double %.112)
  %.117 = fmul contract double %.114, %.111
  br label %B250

B250:
  %wanted.2.0 = phi double [ %.88, %B114 ], [ %.117, %B160 ]
  %.122 = getelementptr i8, ptr %arg.settings, i64 40
  %.123 = load double, ptr %.122, align 8
  %.125 = getelementptr i8, ptr %arg.settings, i64 48
  %.126 = load double, ptr %.125, align 8
  store double 0.000000e+00, ptr %.132, align 8
  %.138 = call i32 @numba.28(ptr nonnull %.132, ptr nonnull %excinfo.2, double %.126, double %wanted.2.0)
  switch i32 %.138, label %B250.if [
    i32 -2, label %B250.endif
    i32 0, label %B250.endif
  ]

B70.if:
  %.50 = icmp sgt i32 %.42, 0
  %.43 = load ptr, ptr %excinfo.1, align 8
  %.51 = select i1 %.50, ptr %.43, ptr undef
  store ptr %.51, ptr %excinfo, align 8
  br label %common.ret

B70.endif:
  %.70 = fcmp contract oeq double %arg.before, 1.000000e+00
  br i1 %.70, label %B114, label %B160

B250.if:
  %.146 = icmp sgt i32 %.138, 0
  %.139 = load ptr, ptr %excinfo.2, align 8
  %.147 = select i1 %.146, ptr %.139, ptr undef
  store ptr %.147, ptr %excinfo, align 8
  br label %common.ret

B250.endif:
  %.148 = load double, ptr %.132, align 8
  store double 0.000000e+00, ptr %.162, align 8
  %.168 = call i32 @numba.21(ptr nonnull %.162, ptr nonnull %excinfo.3, double %.123, double %.148)
  switch i32 %.168, label %B250.endif.if [
    i32 -2, label %B250.endif.endif
    i32 0, label %B250.endif.endif
  ]

B250.endif.if:
  %.176 = icmp sgt i32 %.168, 0
  %.169 = load ptr, ptr %excinfo.3, align 8
  %.177 = select i1 %.176, ptr %.169, ptr undef
  store ptr %.177, ptr %excinfo, align 8
  br label %common.ret

B250.endif.endif:
  %.178 = load double, ptr %.162, align 8
  store double %.178, ptr %retptr, align 8
  br label %common.ret
}

define internal i32 @dense_output.26(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.y, ptr noalias %arg.after, ptr noalias %arg.stages, ptr noalias %arg.method, double %arg.time, double %arg.until, ptr noalias %arg.edges, i64 %arg.count, ptr noalias %arg.outputs, ptr noalias %arg.first, ptr noalias %arg.second, ptr noalias %arg.third) noinline {
entry:
  %.311 = alloca ptr, align 8
  store ptr null, ptr %.311, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.343 = alloca ptr, align 8
  store ptr null, ptr %.343, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.376 = alloca ptr, align 8
  store ptr null, ptr %.376, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.543 = alloca double, align 8
  store double 0.000000e+00, ptr %.543, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.588 = alloca ptr, align 8
  store ptr null, ptr %.588, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.125156.not = icmp slt i64 %arg.n, 1
  br i1 %.125156.not, label %B110.if.preheader, label %B34.if.preheader

B110.if.preheader:
  br label %B110.if

B34.if.preheader:
  %0 = shl nuw i64 %arg.n, 3
  call void @llvm.memset.p0.i64(ptr align 8 %arg.first, i8 0, i64 %0, i1 false)
  %1 = shl nuw i64 %arg.n, 3
  call void @llvm.memset.p0.i64(ptr align 8 %arg.second, i8 0, i64 %1, i1 false)
  %2 = shl nuw i64 %arg.n, 3
  call void @llvm.memset.p0.i64(ptr align 8 %arg.third, i8 0, i64 %2, i1 false)
  br label %B110.if.preheader

B384:
  %.491164.not = icmp slt i64 %arg.count, 1
  br i1 %.491164.not, label %B744, label %B414.if.lr.ph

B414.if.lr.ph:
  %.536 = fsub contract double %arg.until, %arg.time
  %.695161.not = icmp slt i64 %arg.n, 1
  br label %B414.if

B530:
  store ptr null, ptr %.588, align 8
  %.592 = call i32 @copy.27(ptr nonnull %.588, ptr nonnull %excinfo.5, i64 %arg.n, ptr %arg.after, ptr %.575)
  switch i32 %.592, label %B530.if [
    i32 -2, label %B745
    i32 0, label %B745
  ]

common.ret:
  %common.ret.op = phi i32 [ 0, %B744 ], [ %.592, %B530.if ], [ %.549, %B416.endif.if ], [ %.380, %B112.endif.endif.if ], [ %.315, %B112.if ], [ %.347, %B112.endif.if ]
  ret i32 %common.ret.op

B744:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B745:
  %exitcond176.not = icmp eq i64 %.504, %arg.count
  br i1 %exitcond176.not, label %B744, label %B414.if

B110.if:
  %.206.0159 = phi i64 [ %.275, %B112.endif.endif.endif ], [ 0, %B110.if.preheader ]
  %.275 = add nuw nsw i64 %.206.0159, 1
  %.301 = mul nsw i64 %.206.0159, %arg.n
  %.303 = getelementptr double, ptr %arg.stages, i64 %.301
  %3 = getelementptr double, ptr %arg.method, i64 %.206.0159
  %.307 = getelementptr i8, ptr %3, i64 1152
  %.308 = load double, ptr %.307, align 8
  store ptr null, ptr %.311, align 8
  %.315 = call i32 @add_scaled.29(ptr nonnull %.311, ptr nonnull %excinfo.1, i64 %arg.n, double %.308, ptr %.303, ptr %arg.first)
  switch i32 %.315, label %B112.if [
    i32 -2, label %B112.endif
    i32 0, label %B112.endif
  ]

B112.if:
  %.323 = icmp sgt i32 %.315, 0
  %.316 = load ptr, ptr %excinfo.1, align 8
  %.324 = select i1 %.323, ptr %.316, ptr undef
  store ptr %.324, ptr %excinfo, align 8
  br label %common.ret

B112.endif:
  %.339 = getelementptr i8, ptr %3, i64 1216
  %.340 = load double, ptr %.339, align 8
  store ptr null, ptr %.343, align 8
  %.347 = call i32 @add_scaled.29(ptr nonnull %.343, ptr nonnull %excinfo.2, i64 %arg.n, double %.340, ptr %.303, ptr %arg.second)
  switch i32 %.347, label %B112.endif.if [
    i32 -2, label %B112.endif.endif
    i32 0, label %B112.endif.endif
  ]

B112.endif.if:
  %.355 = icmp sgt i32 %.347, 0
  %.348 = load ptr, ptr %excinfo.2, align 8
  %.356 = select i1 %.355, ptr %.348, ptr undef
  store ptr %.356, ptr %excinfo, align 8
  br label %common.ret

B112.endif.endif:
  %.372 = getelementptr i8, ptr %3, i64 1280
  %.373 = load double, ptr %.372, align 8
  store ptr null, ptr %.376, align 8
  %.380 = call i32 @add_scaled.29(ptr nonnull %.376, ptr nonnull %excinfo.3, i64 %arg.n, double %.373, ptr %.303, ptr %arg.third)
  switch i32 %.380, label %B112.endif.endif.if [
    i32 -2, label %B112.endif.endif.endif
    i32 0, label %B112.endif.endif.endif
  ]

B112.endif.endif.if:
  %.388 = icmp sgt i32 %.380, 0
  %.381 = load ptr, ptr %excinfo.3, align 8
  %.389 = select i1 %.388, ptr %.381, ptr undef
  store ptr %.389, ptr %excinfo, align 8
  br label %common.ret

B112.endif.endif.endif:
  %exitcond.not = icmp eq i64 %.275, 8
  br i1 %exitcond.not, label %B384, label %B110.if

B414.if:
  %.435.0165 = phi i64 [ 0, %B414.if.lr.ph ], [ %.504, %B745 ]
  %.504 = add nuw nsw i64 %.435.0165, 1
  %.530 = getelementptr double, ptr %arg.edges, i64 %.435.0165
  %.531 = load double, ptr %.530, align 8
  %.533 = fsub contract double %.531, %arg.time
  %.540 = fdiv contract double %.533, %.536
  store double 0.000000e+00, ptr %.543, align 8
  %.549 = call i32 @numba.21(ptr nonnull %.543, ptr nonnull %excinfo.4, double %.540, double 1.000000e+00)
  %.559 = load double, ptr %.543, align 8
  switch i32 %.549, label %B416.endif.if [
    i32 -2, label %B416.endif.endif
    i32 0, label %B416.endif.endif
  ]

B416.endif.if:
  %.557 = icmp sgt i32 %.549, 0
  %.550 = load ptr, ptr %excinfo.4, align 8
  %.558 = select i1 %.557, ptr %.550, ptr undef
  store ptr %.558, ptr %excinfo, align 8
  br label %common.ret

B416.endif.endif:
  %.573 = mul nsw i64 %.435.0165, %arg.n
  %.575 = getelementptr double, ptr %arg.outputs, i64 %.573
  %.580 = fcmp contract oeq double %.559, 1.000000e+00
  br i1 %.580, label %B530, label %B596.preheader

B596.preheader:
  br i1 %.695161.not, label %B745, label %B596.if.lr.ph

B596.if.lr.ph:
  %.749 = fsub contract double 1.000000e+00, %.559
  br label %B596.if

B530.if:
  %.600 = icmp sgt i32 %.592, 0
  %.593 = load ptr, ptr %excinfo.5, align 8
  %.601 = select i1 %.600, ptr %.593, ptr undef
  store ptr %.601, ptr %excinfo, align 8
  br label %common.ret

B596.if:
  %.639.0162 = phi i64 [ 0, %B596.if.lr.ph ], [ %.708, %B596.if ]
  %.708 = add nuw nsw i64 %.639.0162, 1
  %.734 = getelementptr double, ptr %arg.first, i64 %.639.0162
  %.735 = load double, ptr %.734, align 8
  %.737 = getelementptr double, ptr %arg.second, i64 %.639.0162
  %.738 = load double, ptr %.737, align 8
  %.740 = getelementptr double, ptr %arg.third, i64 %.639.0162
  %.741 = load double, ptr %.740, align 8
  %.743 = fmul contract double %.559, %.741
  %.744 = fadd contract double %.738, %.743
  %.746 = fmul contract double %.559, %.744
  %.747 = fadd contract double %.735, %.746
  %.751 = getelementptr double, ptr %arg.y, i64 %.639.0162
  %.752 = load double, ptr %.751, align 8
  %.753 = fmul contract double %.749, %.752
  %.755 = getelementptr double, ptr %arg.after, i64 %.639.0162
  %.756 = load double, ptr %.755, align 8
  %.759 = fmul contract double %.749, %.747
  %.760 = fadd contract double %.756, %.759
  %.762 = fmul contract double %.559, %.760
  %.763 = fadd contract double %.753, %.762
  %.765 = getelementptr double, ptr %.575, i64 %.639.0162
  store double %.763, ptr %.765, align 8
  %exitcond175.not = icmp eq i64 %arg.n, %.708
  br i1 %exitcond175.not, label %B745, label %B596.if
}

define internal i32 @copy.27(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y) {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B62, label %B34.if.preheader

B34.if.preheader:
  %0 = shl nuw i64 %arg.n, 3
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %arg.y, ptr align 8 %arg.x, i64 %0, i1 false)
  br label %B62

B62:
  store ptr null, ptr %retptr, align 8
  ret i32 0
}

define internal i32 @numba.28(ptr noalias %retptr, ptr noalias %excinfo, double %arg.x.0, double %arg.x.1) {
entry:
  %.10 = fcmp contract ogt double %arg.x.1, %arg.x.0
  %.11 = select i1 %.10, double %arg.x.1, double %arg.x.0
  store double %.11, ptr %retptr, align 8
  ret i32 0
}

define internal i32 @numba.21(ptr noalias %retptr, ptr noalias %excinfo, double %arg.x.0, double %arg.x.1) {
entry:
  %.10 = fcmp contract olt double %arg.x.1, %arg.x.0
  %.11 = select i1 %.10, double %arg.x.1, double %arg.x.0
  store double %.11, ptr %retptr, align 8
  ret i32 0
}

define internal i32 @lu_fill.23(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, i32 %arg.count, ptr noalias %arg.J, ptr noalias %arg.own, ptr noalias %arg.mass, double %arg.scale, ptr noalias %arg.lu) noinline {
entry:
  %.23 = sext i32 %arg.count to i64
  %.24 = shl nsw i64 %.23, 2
  %.62 = icmp slt i32 %arg.count, 1
  %storemerge = select i1 %.62, i64 0, i64 %.24
  %.10673 = icmp sgt i64 %storemerge, 0
  br i1 %.10673, label %B40.if, label %B70

B70:
  %.23876.not = icmp slt i64 %arg.n, 1
  br i1 %.23876.not, label %B168, label %B100.if

B168:
  %.304 = getelementptr i32, ptr %arg.own, i64 %arg.n
  %.305 = load i32, ptr %.304, align 4
  %.307 = icmp sgt i32 %.305, -1
  br i1 %.307, label %B192, label %common.ret

common.ret:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B192:
  %.306 = zext nneg i32 %.305 to i64
  %.319 = getelementptr double, ptr %arg.lu, i64 %.306
  store double 1.000000e+00, ptr %.319, align 8
  br label %common.ret

B40.if:
  %.48.074 = phi i64 [ %.119, %B40.if ], [ 0, %entry ]
  %.119 = add nuw nsw i64 %.48.074, 1
  %.145 = getelementptr double, ptr %arg.J, i64 %.48.074
  %.146 = load double, ptr %.145, align 8
  %.147 = fneg contract double %.146
  %.149 = getelementptr double, ptr %arg.lu, i64 %.48.074
  store double %.147, ptr %.149, align 8
  %exitcond.not = icmp eq i64 %.119, %storemerge
  br i1 %exitcond.not, label %B70, label %B40.if

B100.if:
  %.182.077 = phi i64 [ %.251, %B100.if ], [ 0, %B70 ]
  %.251 = add nuw nsw i64 %.182.077, 1
  %.277 = getelementptr i32, ptr %arg.own, i64 %.182.077
  %.278 = load i32, ptr %.277, align 4
  %.280 = sext i32 %.278 to i64
  %.281 = getelementptr double, ptr %arg.lu, i64 %.280
  %.282 = load double, ptr %.281, align 8
  %.284 = getelementptr double, ptr %arg.mass, i64 %.182.077
  %.285 = load double, ptr %.284, align 8
  %.287 = fmul contract double %arg.scale, %.285
  %.288 = fadd contract double %.282, %.287
  store double %.288, ptr %.281, align 8
  %exitcond79.not = icmp eq i64 %arg.n, %.251
  br i1 %exitcond79.not, label %B168, label %B100.if
}

define internal i32 @add_scaled.29(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, double %arg.factor, ptr noalias %arg.x, ptr noalias %arg.y) {
entry:
  %.9534.not = icmp slt i64 %arg.n, 1
  br i1 %.9534.not, label %B90, label %B34.if

B90:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.035 = phi i64 [ %.108, %B34.if ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.035, 1
  %.134 = getelementptr double, ptr %arg.y, i64 %.37.035
  %.135 = load double, ptr %.134, align 8
  %.137 = getelementptr double, ptr %arg.x, i64 %.37.035
  %.138 = load double, ptr %.137, align 8
  %.140 = fmul contract double %arg.factor, %.138
  %.141 = fadd contract double %.135, %.140
  store double %.141, ptr %.134, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B90, label %B34.if
}

define internal i32 @step_error.30(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, i64 %arg.tested, ptr noalias %arg.y, ptr noalias %arg.after, ptr noalias %arg.apart, ptr noalias %arg.powers, double %arg.lead, double %arg.tolerance) noinline {
entry:
  %.350 = alloca double, align 8
  store double 0.000000e+00, ptr %.350, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.424 = alloca double, align 8
  store double 0.000000e+00, ptr %.424, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.624 = alloca double, align 8
  store double 0.000000e+00, ptr %.624, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %storemerge = call i64 @llvm.smax.i64(i64 %arg.n, i64 0)
  br label %B38

B38:
  %.55.0 = phi i64 [ 0, %entry ], [ %.126, %B94 ]
  %exitcond.not = icmp eq i64 %.55.0, %storemerge
  br i1 %exitcond.not, label %B176, label %B38.if

B94:
  %.126 = add nuw i64 %.55.0, 1
  %.163 = getelementptr double, ptr %arg.apart, i64 %.55.0
  %.164 = load double, ptr %.163, align 8
  %.167 = fsub contract double %.164, %.164
  %.168 = fcmp contract ord double %.167, 0.000000e+00
  br i1 %.168, label %B38, label %B146

common.ret:
  %common.ret.op = phi i32 [ 0, %B146 ], [ 0, %B694 ], [ %.630, %B542.endif.if ], [ %.356, %B254.if ], [ %.430, %B474.if ]
  ret i32 %common.ret.op

B146:
  store double 0x7FF0000000000000, ptr %retptr, align 8
  br label %common.ret

B176:
  %.285137.not = icmp slt i64 %arg.tested, 1
  br i1 %.285137.not, label %B508, label %B206.if

B254:
  %.340 = getelementptr double, ptr %arg.y, i64 %.229.0138
  %.341 = load double, ptr %.340, align 8
  %.342 = call contract double @llvm.fabs.f64(double %.341)
  %.345 = getelementptr double, ptr %arg.after, i64 %.229.0138
  %.346 = load double, ptr %.345, align 8
  %.347 = call contract double @llvm.fabs.f64(double %.346)
  store double 0.000000e+00, ptr %.350, align 8
  %.356 = call i32 @numba.28(ptr nonnull %.350, ptr nonnull %excinfo.1, double %.342, double %.347)
  switch i32 %.356, label %B254.if [
    i32 -2, label %B254.endif
    i32 0, label %B254.endif
  ]

B446:
  %.408 = call contract double @llvm.pow.f64(double %arg.lead, double %.333)
  %.410 = fmul contract double %.408, %.387
  br label %B474

B474:
  %error.3.1 = phi double [ %.410, %B446 ], [ %.387, %B254.endif ]
  store double 0.000000e+00, ptr %.424, align 8
  %.430 = call i32 @numba.28(ptr nonnull %.424, ptr nonnull %excinfo.2, double %worst.3.0140, double %error.3.1)
  switch i32 %.430, label %B474.if [
    i32 -2, label %B474.endif
    i32 0, label %B474.endif
  ]

B506:
  %worst.4.1 = phi double [ %.440, %B474.endif ], [ %worst.3.0140, %B206.if ]
  %exitcond148.not = icmp eq i64 %arg.tested, %.298
  br i1 %exitcond148.not, label %B508, label %B206.if

B508:
  %worst.3.0.lcssa = phi double [ 0.000000e+00, %B176 ], [ %worst.4.1, %B506 ]
  %.521 = sub i64 %arg.n, %arg.tested
  %.564141.not = icmp slt i64 %.521, 1
  br i1 %.564141.not, label %B694, label %B540.if

B694:
  %worst.5.0.lcssa = phi double [ %worst.3.0.lcssa, %B508 ], [ %.640, %B542.endif.endif ]
  store double %worst.5.0.lcssa, ptr %retptr, align 8
  br label %common.ret

B38.if:
  %.156 = getelementptr double, ptr %arg.after, i64 %.55.0
  %.157 = load double, ptr %.156, align 8
  %.158 = fsub contract double %.157, %.157
  %.159 = fcmp contract ord double %.158, 0.000000e+00
  br i1 %.159, label %B94, label %B146

B206.if:
  %worst.3.0140 = phi double [ %worst.4.1, %B506 ], [ 0.000000e+00, %B176 ]
  %.229.0138 = phi i64 [ %.298, %B506 ], [ 0, %B176 ]
  %.298 = add nuw nsw i64 %.229.0138, 1
  %.332 = getelementptr double, ptr %arg.powers, i64 %.229.0138
  %.333 = load double, ptr %.332, align 8
  %.334 = fcmp contract ueq double %.333, 0x7FF0000000000000
  br i1 %.334, label %B506, label %B254

B254.if:
  %.364 = icmp sgt i32 %.356, 0
  %.357 = load ptr, ptr %excinfo.1, align 8
  %.365 = select i1 %.364, ptr %.357, ptr undef
  store ptr %.365, ptr %excinfo, align 8
  br label %common.ret

B254.endif:
  %.366 = load double, ptr %.350, align 8
  %.378 = getelementptr double, ptr %arg.apart, i64 %.229.0138
  %.379 = load double, ptr %.378, align 8
  %.380 = call contract double @llvm.fabs.f64(double %.379)
  %.381 = fadd contract double %.366, 1.000000e+00
  %.383 = fmul contract double %arg.tolerance, %.381
  %.387 = fdiv contract double %.380, %.383
  %.399 = fcmp contract une double %.333, 0.000000e+00
  br i1 %.399, label %B446, label %B474

B474.if:
  %.438 = icmp sgt i32 %.430, 0
  %.431 = load ptr, ptr %excinfo.2, align 8
  %.439 = select i1 %.438, ptr %.431, ptr undef
  store ptr %.439, ptr %excinfo, align 8
  br label %common.ret

B474.endif:
  %.440 = load double, ptr %.424, align 8
  br label %B506

B540.if:
  %worst.5.0144 = phi double [ %.640, %B542.endif.endif ], [ %worst.3.0.lcssa, %B508 ]
  %.511.0143 = phi i64 [ %.573, %B542.endif.endif ], [ %.521, %B508 ]
  %.508.0142 = phi i64 [ %.577, %B542.endif.endif ], [ %arg.tested, %B508 ]
  %.603 = getelementptr double, ptr %arg.apart, i64 %.508.0142
  %.604 = load double, ptr %.603, align 8
  %.605 = call contract double @llvm.fabs.f64(double %.604)
  %.607 = getelementptr double, ptr %arg.after, i64 %.508.0142
  %.608 = load double, ptr %.607, align 8
  %.610 = getelementptr double, ptr %arg.y, i64 %.508.0142
  %.611 = load double, ptr %.610, align 8
  %.612 = fsub contract double %.608, %.611
  %.613 = call contract double @llvm.fabs.f64(double %.612)
  %.614 = fadd contract double %.613, 1.000000e+00
  %.616 = fmul contract double %arg.tolerance, %.614
  %.620 = fdiv contract double %.605, %.616
  store double 0.000000e+00, ptr %.624, align 8
  %.630 = call i32 @numba.28(ptr nonnull %.624, ptr nonnull %excinfo.3, double %worst.5.0144, double %.620)
  switch i32 %.630, label %B542.endif.if [
    i32 -2, label %B542.endif.endif
    i32 0, label %B542.endif.endif
  ]

B542.endif.if:
  %.638 = icmp sgt i32 %.630, 0
  %.631 = load ptr, ptr %excinfo.3, align 8
  %.639 = select i1 %.638, ptr %.631, ptr undef
  store ptr %.639, ptr %excinfo, align 8
  br label %common.ret

B542.endif.endif:
  %.577 = add i64 %.508.0142, 1
  %.573 = add nsw i64 %.511.0143, -1
  %.640 = load double, ptr %.624, align 8
  %.564 = icmp sgt i64 %.511.0143, 1
  br i1 %.564, label %B540.if, label %B694
}

declare double @llvm.fabs.f64(double)

declare double @llvm.pow.f64(double, double)

define internal i32 @combine.31(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, i64 %arg.count, ptr noalias %arg.weights, double %arg.h, ptr noalias %arg.mass, ptr noalias %arg.stages, ptr noalias %arg.right, ptr noalias %arg.pull) noinline {
entry:
  %.307 = alloca ptr, align 8
  store ptr null, ptr %.307, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.29 = icmp eq i64 %arg.count, 0
  br i1 %.29, label %B16, label %B20

common.ret:
  %common.ret.op = phi i32 [ 0, %B16 ], [ 0, %B288 ], [ %.311, %B98.if ]
  ret i32 %common.ret.op

B16:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B20:
  %.131113.not = icmp slt i64 %arg.n, 1
  br i1 %.131113.not, label %B66, label %B50.if.preheader

B50.if.preheader:
  %0 = shl nuw i64 %arg.n, 3
  call void @llvm.memset.p0.i64(ptr align 8 %arg.pull, i8 0, i64 %0, i1 false)
  br label %B66

B66:
  %storemerge111 = call i64 @llvm.smax.i64(i64 %arg.count, i64 0)
  %.259116.not = icmp eq i64 %storemerge111, 0
  br i1 %.259116.not, label %B214.preheader, label %B96.if

B214.preheader:
  %.422119.not = icmp slt i64 %arg.n, 1
  br i1 %.422119.not, label %B288, label %B214.if

B288:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B96.if:
  %.203.0117 = phi i64 [ %.272, %B98.endif ], [ 0, %B66 ]
  %.299 = getelementptr double, ptr %arg.weights, i64 %.203.0117
  %.300 = load double, ptr %.299, align 8
  %.302 = mul nsw i64 %.203.0117, %arg.n
  %.304 = getelementptr double, ptr %arg.stages, i64 %.302
  store ptr null, ptr %.307, align 8
  %.311 = call i32 @add_scaled.29(ptr nonnull %.307, ptr nonnull %excinfo.1, i64 %arg.n, double %.300, ptr %.304, ptr %arg.pull)
  switch i32 %.311, label %B98.if [
    i32 -2, label %B98.endif
    i32 0, label %B98.endif
  ]

B98.if:
  %.319 = icmp sgt i32 %.311, 0
  %.312 = load ptr, ptr %excinfo.1, align 8
  %.320 = select i1 %.319, ptr %.312, ptr undef
  store ptr %.320, ptr %excinfo, align 8
  br label %common.ret

B98.endif:
  %.272 = add nuw nsw i64 %.203.0117, 1
  %exitcond.not = icmp eq i64 %arg.count, %.272
  br i1 %exitcond.not, label %B214.preheader, label %B96.if

B214.if:
  %.366.0120 = phi i64 [ %.435, %B214.if ], [ 0, %B214.preheader ]
  %.435 = add nuw nsw i64 %.366.0120, 1
  %.461 = getelementptr double, ptr %arg.right, i64 %.366.0120
  %.462 = load double, ptr %.461, align 8
  %.464 = getelementptr double, ptr %arg.mass, i64 %.366.0120
  %.465 = load double, ptr %.464, align 8
  %.467 = getelementptr double, ptr %arg.pull, i64 %.366.0120
  %.468 = load double, ptr %.467, align 8
  %.469 = fmul contract double %.465, %.468
  %.474 = fdiv contract double %.469, %arg.h
  %.475 = fadd contract double %.462, %.474
  store double %.475, ptr %.461, align 8
  %exitcond123.not = icmp eq i64 %arg.n, %.435
  br i1 %exitcond123.not, label %B288, label %B214.if
}

define i64 @sums_of_rows(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, i64 %a5, i64 %a6, ptr %a7, i64 %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @sums_of_rows.32(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, i64 %a5, i64 %a6, ptr %a7, i64 %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13)
  ret i64 0
}

define internal i32 @sums_of_rows.32(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.pos, i64 %arg.count, i64 %arg.own, ptr noalias %arg.numbers, i64 %arg.length, ptr noalias %arg.Y, ptr noalias %arg.J, ptr noalias %arg.r, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.189 = alloca ptr, align 8
  store ptr null, ptr %.189, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.224 = alloca ptr, align 8
  store ptr null, ptr %.224, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.262 = alloca ptr, align 8
  store ptr null, ptr %.262, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.45 = getelementptr i8, ptr %arg.layout, i64 16
  %.46 = load i64, ptr %.45, align 8
  %.47 = add nsw i64 %.46, 1
  %.49 = getelementptr i8, ptr %arg.layout, i64 24
  %.50 = load i64, ptr %.49, align 8
  %.51 = add nsw i64 %.47, %.50
  %.13644.not = icmp slt i64 %arg.count, 1
  br i1 %.13644.not, label %B412, label %B94.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B412 ], [ %.266, %B96.endif.endif.if ], [ %.228, %B96.endif.if ], [ %.193, %B96.if ]
  ret i32 %common.ret.op

B412:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B94.if:
  %.78.045 = phi i64 [ %.149, %B96.endif.endif.endif ], [ 0, %entry ]
  %.149 = add nuw nsw i64 %.78.045, 1
  %.175 = mul nsw i64 %.78.045, %arg.own
  %.177 = getelementptr double, ptr %arg.numbers, i64 %.175
  %.179 = mul nsw i64 %.78.045, %arg.length
  %.181 = getelementptr double, ptr %arg.Y, i64 %.179
  store ptr null, ptr %.189, align 8
  %.193 = call i32 @drive.6(ptr nonnull %.189, ptr nonnull %excinfo.1, ptr %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %.177, ptr %.181, ptr %arg.local, ptr %arg.out)
  switch i32 %.193, label %B96.if [
    i32 -2, label %B96.endif
    i32 0, label %B96.endif
  ]

B96.if:
  %.201 = icmp sgt i32 %.193, 0
  %.194 = load ptr, ptr %excinfo.1, align 8
  %.202 = select i1 %.201, ptr %.194, ptr undef
  store ptr %.202, ptr %excinfo, align 8
  br label %common.ret

B96.endif:
  %.215 = mul nsw i64 %.78.045, %.51
  %.217 = getelementptr double, ptr %arg.J, i64 %.215
  store ptr null, ptr %.224, align 8
  %.228 = call i32 @jacobian.4(ptr nonnull %.224, ptr nonnull %excinfo.2, ptr %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.pos, ptr %.177, ptr %.181, ptr %.217, ptr %arg.local, ptr %arg.out)
  switch i32 %.228, label %B96.endif.if [
    i32 -2, label %B96.endif.endif
    i32 0, label %B96.endif.endif
  ]

B96.endif.if:
  %.236 = icmp sgt i32 %.228, 0
  %.229 = load ptr, ptr %excinfo.2, align 8
  %.237 = select i1 %.236, ptr %.229, ptr undef
  store ptr %.237, ptr %excinfo, align 8
  br label %common.ret

B96.endif.endif:
  %.250 = load i64, ptr %arg.layout, align 8
  %.251 = add nsw i64 %.250, 1
  %.252 = mul nsw i64 %.251, %.78.045
  %.254 = getelementptr double, ptr %arg.r, i64 %.252
  store ptr null, ptr %.262, align 8
  %.266 = call i32 @residual.0(ptr nonnull %.262, ptr nonnull %excinfo.3, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %.177, ptr %.181, ptr %.254, ptr %arg.local, ptr %arg.out)
  switch i32 %.266, label %B96.endif.endif.if [
    i32 -2, label %B96.endif.endif.endif
    i32 0, label %B96.endif.endif.endif
  ]

B96.endif.endif.if:
  %.274 = icmp sgt i32 %.266, 0
  %.267 = load ptr, ptr %excinfo.3, align 8
  %.275 = select i1 %.274, ptr %.267, ptr undef
  store ptr %.275, ptr %excinfo, align 8
  br label %common.ret

B96.endif.endif.endif:
  %exitcond.not = icmp eq i64 %arg.count, %.149
  br i1 %exitcond.not, label %B412, label %B94.if
}

define i64 @march_rows(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, i64 %a7, ptr %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, i64 %a14, ptr %a15, ptr %a16, i64 %a17, i64 %a18, ptr %a19, i64 %a20, ptr %a21, ptr %a22, ptr %a23, ptr %a24, ptr %a25, i64 %a26, ptr %a27, ptr %a28, ptr %a29, ptr %a30, ptr %a31) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @march_rows.33(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, i64 %a7, ptr %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, i64 %a14, ptr %a15, ptr %a16, i64 %a17, i64 %a18, ptr %a19, i64 %a20, ptr %a21, ptr %a22, ptr %a23, ptr %a24, ptr %a25, i64 %a26, ptr %a27, ptr %a28, ptr %a29, ptr %a30, ptr %a31)
  ret i64 0
}

define internal i32 @march_rows.33(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.pos, ptr noalias %arg.drive_rows, ptr noalias %arg.drive_columns, i64 %arg.blocks, ptr noalias %arg.slot, ptr noalias %arg.slots, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.mass, i64 %arg.tested, ptr noalias %arg.powers, ptr noalias %arg.method, i64 %arg.count, i64 %arg.own, ptr noalias %arg.numbers, i64 %arg.length, ptr noalias %arg.Y, ptr noalias %arg.y, ptr noalias %arg.settings, ptr noalias %arg.first_edges, ptr noalias %arg.edges, i64 %arg.max_steps, ptr noalias %arg.state, ptr noalias %arg.counts, ptr noalias %arg.outputs, ptr noalias %arg.status, ptr noalias %arg.work) noinline {
entry:
  %.280 = alloca i64, align 8
  store i64 0, ptr %.280, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.100 = load i64, ptr %arg.layout, align 8
  %.18543.not = icmp slt i64 %arg.count, 1
  br i1 %.18543.not, label %B524, label %B60.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B524 ], [ %.284, %B62.if ]
  ret i32 %common.ret.op

B524:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B60.if:
  %.127.044 = phi i64 [ %.198, %B62.endif ], [ 0, %entry ]
  %.224 = getelementptr i64, ptr %arg.first_edges, i64 %.127.044
  %.225 = load i64, ptr %.224, align 8
  %.228 = mul nsw i64 %.127.044, %arg.own
  %.230 = getelementptr double, ptr %arg.numbers, i64 %.228
  %.233.idx = shl i64 %.127.044, 6
  %.233 = getelementptr i8, ptr %arg.settings, i64 %.233.idx
  %.235 = getelementptr double, ptr %arg.edges, i64 %.225
  %.238 = getelementptr i8, ptr %.224, i64 8
  %.239 = load i64, ptr %.238, align 8
  %.240 = sub nsw i64 %.239, %.225
  %.242 = mul nsw i64 %.127.044, %.100
  %.244 = getelementptr double, ptr %arg.y, i64 %.242
  %.246 = mul nsw i64 %.127.044, %arg.length
  %.248 = getelementptr double, ptr %arg.Y, i64 %.246
  %.251.idx = mul i64 %.127.044, 24
  %.251 = getelementptr i8, ptr %arg.state, i64 %.251.idx
  %.254.idx = mul i64 %.127.044, 48
  %.254 = getelementptr i8, ptr %arg.counts, i64 %.254.idx
  %.256 = mul nsw i64 %.225, %.100
  %.258 = getelementptr double, ptr %arg.outputs, i64 %.256
  store i64 0, ptr %.280, align 8
  %.284 = call i32 @march.34(ptr nonnull %.280, ptr nonnull %excinfo.1, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.pos, ptr %.230, ptr %arg.drive_rows, ptr %arg.drive_columns, i64 %arg.blocks, ptr %arg.slot, ptr %arg.slots, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %arg.mass, i64 %arg.tested, ptr %arg.powers, ptr %arg.method, ptr %.233, ptr %.235, i64 %.240, i64 %arg.max_steps, ptr %.244, ptr %.248, ptr %.251, ptr %.254, ptr %.258, i64 -1, ptr %arg.work, ptr %arg.work)
  switch i32 %.284, label %B62.if [
    i32 -2, label %B62.endif
    i32 0, label %B62.endif
  ]

B62.if:
  %.292 = icmp sgt i32 %.284, 0
  %.285 = load ptr, ptr %excinfo.1, align 8
  %.293 = select i1 %.292, ptr %.285, ptr undef
  store ptr %.293, ptr %excinfo, align 8
  br label %common.ret

B62.endif:
  %.198 = add nuw nsw i64 %.127.044, 1
  %.294 = load i64, ptr %.280, align 8
  %.305 = getelementptr i64, ptr %arg.status, i64 %.127.044
  store i64 %.294, ptr %.305, align 8
  %exitcond.not = icmp eq i64 %arg.count, %.198
  br i1 %exitcond.not, label %B524, label %B60.if
}

define internal i32 @march.34(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.pos, ptr noalias %arg.numbers, ptr noalias %arg.drive_rows, ptr noalias %arg.drive_columns, i64 %arg.blocks, ptr noalias %arg.own, ptr noalias %arg.slots, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.mass, i64 %arg.tested, ptr noalias %arg.powers, ptr noalias %arg.method, ptr noalias %arg.settings, ptr noalias %arg.edges, i64 %arg.edge_count, i64 %arg.max_steps, ptr noalias %arg.y, ptr noalias %arg.Y, ptr noalias %arg.state, ptr noalias %arg.counts, ptr noalias %arg.outputs, i64 %arg.most_recorded, ptr noalias %arg.record, ptr noalias %arg.work) noinline {
entry:
  %.485 = alloca double, align 8
  store double 0.000000e+00, ptr %.485, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.541 = alloca ptr, align 8
  store ptr null, ptr %.541, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.594 = alloca ptr, align 8
  store ptr null, ptr %.594, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.625 = alloca i64, align 8
  store i64 0, ptr %.625, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.687 = alloca ptr, align 8
  store ptr null, ptr %.687, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.727 = alloca ptr, align 8
  store ptr null, ptr %.727, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.754 = alloca ptr, align 8
  store ptr null, ptr %.754, align 8
  %excinfo.7 = alloca ptr, align 8
  store ptr null, ptr %excinfo.7, align 8
  %.788 = alloca double, align 8
  store double 0.000000e+00, ptr %.788, align 8
  %excinfo.8 = alloca ptr, align 8
  store ptr null, ptr %excinfo.8, align 8
  %.823 = alloca double, align 8
  store double 0.000000e+00, ptr %.823, align 8
  %excinfo.9 = alloca ptr, align 8
  store ptr null, ptr %excinfo.9, align 8
  %.872 = alloca double, align 8
  store double 0.000000e+00, ptr %.872, align 8
  %excinfo.10 = alloca ptr, align 8
  store ptr null, ptr %excinfo.10, align 8
  %.1145 = alloca ptr, align 8
  store ptr null, ptr %.1145, align 8
  %excinfo.11 = alloca ptr, align 8
  store ptr null, ptr %excinfo.11, align 8
  %.1191 = alloca double, align 8
  store double 0.000000e+00, ptr %.1191, align 8
  %excinfo.12 = alloca ptr, align 8
  store ptr null, ptr %excinfo.12, align 8
  %.1284 = alloca ptr, align 8
  store ptr null, ptr %.1284, align 8
  %excinfo.14 = alloca ptr, align 8
  store ptr null, ptr %excinfo.14, align 8
  %.1410 = alloca double, align 8
  store double 0.000000e+00, ptr %.1410, align 8
  %excinfo.15 = alloca ptr, align 8
  store ptr null, ptr %excinfo.15, align 8
  %.1452 = alloca double, align 8
  store double 0.000000e+00, ptr %.1452, align 8
  %excinfo.16 = alloca ptr, align 8
  store ptr null, ptr %excinfo.16, align 8
  %.1507 = alloca double, align 8
  store double 0.000000e+00, ptr %.1507, align 8
  %excinfo.17 = alloca ptr, align 8
  store ptr null, ptr %excinfo.17, align 8
  %.1539 = alloca double, align 8
  store double 0.000000e+00, ptr %.1539, align 8
  %excinfo.18 = alloca ptr, align 8
  store ptr null, ptr %excinfo.18, align 8
  %.92 = load i64, ptr %arg.layout, align 8
  %.94 = getelementptr i8, ptr %arg.layout, i64 16
  %.95 = load i64, ptr %.94, align 8
  %.105.idx = shl i64 %.92, 6
  %.105 = getelementptr i8, ptr %arg.work, i64 %.105.idx
  %.108.idx = mul i64 %.92, 72
  %.108 = getelementptr i8, ptr %arg.work, i64 %.108.idx
  %.idx = mul i64 %.92, 80
  %0 = getelementptr i8, ptr %arg.work, i64 %.idx
  %.112 = getelementptr i8, ptr %0, i64 8
  %.idx164 = mul i64 %.92, 88
  %1 = getelementptr i8, ptr %arg.work, i64 %.idx164
  %.125 = getelementptr i8, ptr %1, i64 8
  %.idx165 = mul i64 %.92, 96
  %2 = getelementptr i8, ptr %arg.work, i64 %.idx165
  %.129 = getelementptr i8, ptr %2, i64 8
  %.139.idx = shl i64 %arg.blocks, 5
  %.139 = getelementptr i8, ptr %.129, i64 %.139.idx
  %.146.idx = shl i64 %arg.blocks, 4
  %.146 = getelementptr i8, ptr %.139, i64 %.146.idx
  %.151 = getelementptr double, ptr %.146, i64 %.95
  %.157 = getelementptr i8, ptr %arg.layout, i64 24
  %.158 = load i64, ptr %.157, align 8
  %3 = getelementptr double, ptr %.151, i64 %.95
  %4 = getelementptr i8, ptr %3, i64 8
  %.161 = getelementptr double, ptr %4, i64 %.158
  %.166 = getelementptr i8, ptr %arg.layout, i64 8
  %.167 = load i64, ptr %.166, align 8
  %5 = getelementptr double, ptr %.161, i64 %.167
  %.170 = getelementptr i8, ptr %5, i64 8
  %.175 = getelementptr i8, ptr %arg.layout, i64 256
  %.176 = load i64, ptr %.175, align 8
  %.178 = getelementptr double, ptr %.170, i64 %.176
  %6 = getelementptr double, ptr %arg.edges, i64 %arg.edge_count
  %.185 = getelementptr i8, ptr %6, i64 -8
  %.186 = load double, ptr %.185, align 8
  %.192 = load i64, ptr %arg.counts, align 8
  %.284263.not = icmp slt i64 %arg.max_steps, 1
  br i1 %.284263.not, label %B2754, label %B672.if.lr.ph

B672.if.lr.ph:
  %.424 = getelementptr i8, ptr %arg.state, i64 8
  %.566 = getelementptr i8, ptr %arg.counts, i64 32
  %.576 = getelementptr i8, ptr %arg.method, i64 1344
  %.587 = getelementptr i32, ptr %arg.lu_start, i64 %arg.blocks
  %.650 = getelementptr i8, ptr %arg.counts, i64 8
  %.712 = getelementptr i8, ptr %arg.counts, i64 24
  %.722.idx = mul i64 %.92, 56
  %.722 = getelementptr i8, ptr %arg.work, i64 %.722.idx
  %.779 = getelementptr i8, ptr %arg.settings, i64 8
  %.1184 = getelementptr i8, ptr %arg.state, i64 16
  %.1187 = getelementptr i8, ptr %arg.method, i64 1352
  %.1503 = getelementptr i8, ptr %arg.settings, i64 16
  %.860 = getelementptr i8, ptr %arg.counts, i64 16
  %.868 = getelementptr i8, ptr %arg.method, i64 1352
  %.909 = getelementptr i8, ptr %arg.settings, i64 24
  %.424.promoted = load double, ptr %.424, align 8
  %7 = add i64 %arg.edge_count, -1
  br label %B672.if

common.ret:
  %common.ret.op = phi i32 [ %.1545, %B2622.endif.if ], [ 0, %B1748 ], [ 0, %B2754 ], [ %.1458, %B2494.endif.endif.if ], [ %.1513, %B2622.if ], [ %.491, %B818.endif.if ], [ %.545, %B860.if ], [ %.598, %B966.endif.if ], [ %.629, %B966.endif.endif.if ], [ %.691, %B1176.if ], [ %.731, %B1176.endif.if ], [ %.758, %B1176.endif.endif.if ], [ %.794, %B1176.endif.endif.endif.endif.if ], [ %.827, %B1176.endif.endif.endif.endif.endif.if ], [ %.876, %B1570.if ], [ %.1149, %B1942.if ], [ %.1195, %B2156.if ], [ %.1416, %B2494.if ], [ %.1288, %B2436.if ], [ 0, %B2494.endif.endif.endif ]
  ret i32 %common.ret.op

B800:
  %.470 = fmul contract double %.434, 5.000000e-01
  %.472 = fcmp contract ogt double %.425266, %.470
  br i1 %.472, label %B818, label %B856

B818:
  store double 0.000000e+00, ptr %.485, align 8
  %.491 = call i32 @numba.21(ptr nonnull %.485, ptr nonnull %excinfo.1, double %.425266, double %.470)
  switch i32 %.491, label %B818.endif.if [
    i32 -2, label %B818.endif.endif
    i32 0, label %B818.endif.endif
  ]

B856:
  %h.3.1 = phi double [ %.425266, %B800 ], [ %.501, %B818.endif.endif ], [ %.434, %B672.if ]
  br i1 %fresh.3.0265, label %B966, label %B860

B860:
  store ptr null, ptr %.541, align 8
  %.545 = call i32 @linearise.22(ptr nonnull %.541, ptr nonnull %excinfo.2, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.pos, ptr %arg.numbers, ptr %arg.drive_rows, ptr %arg.drive_columns, double %.422, ptr %arg.y, ptr %arg.Y, ptr %.151, ptr %.161, ptr %.125, ptr %.170, ptr %.178)
  switch i32 %.545, label %B860.if [
    i32 -2, label %B860.endif
    i32 0, label %B860.endif
  ]

B966:
  %.577 = load double, ptr %.576, align 8
  %.579 = fmul contract double %h.3.1, %.577
  %.583 = fdiv contract double 1.000000e+00, %.579
  %.588 = load i32, ptr %.587, align 4
  store ptr null, ptr %.594, align 8
  %.598 = call i32 @lu_fill.23(ptr nonnull %.594, ptr nonnull %excinfo.3, i64 %.92, i32 %.588, ptr %.151, ptr %arg.own, ptr %arg.mass, double %.583, ptr %.146)
  switch i32 %.598, label %B966.endif.if [
    i32 -2, label %B966.endif.endif
    i32 0, label %B966.endif.endif
  ]

B1176:
  store ptr null, ptr %.687, align 8
  %.691 = call i32 @solve_stages.24(ptr nonnull %.687, ptr nonnull %excinfo.5, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, i64 %arg.blocks, ptr %arg.slots, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %arg.mass, ptr %arg.method, double %.422, double %h.3.1, ptr %arg.y, ptr %arg.Y, ptr %.125, ptr %.146, ptr %arg.work, ptr %.105, i64 0, ptr %.108, ptr %.112, ptr %.139, ptr %.170, ptr %.178)
  switch i32 %.691, label %B1176.if [
    i32 -2, label %B1176.endif
    i32 0, label %B1176.endif
  ]

B1558:
  %error.2.1 = phi double [ %.837, %B1176.endif.endif.endif.endif.endif.endif ], [ 0x7FF0000000000000, %B966.endif.endif.endif ]
  %.851 = fcmp contract ugt double %error.2.1, 1.000000e+00
  br i1 %.851, label %B1570, label %B1770

B1570:
  %.861 = load i64, ptr %.860, align 8
  %.862 = add nsw i64 %.861, 1
  store i64 %.862, ptr %.860, align 8
  %.869 = load double, ptr %.868, align 8
  store double 0.000000e+00, ptr %.872, align 8
  %.876 = call i32 @step_factor.25(ptr nonnull %.872, ptr nonnull %excinfo.10, double %error.2.1, double 1.000000e+00, double %.869, ptr %arg.settings)
  switch i32 %.876, label %B1570.if [
    i32 -2, label %B1570.endif
    i32 0, label %B1570.endif
  ]

B1748:
  store i64 2, ptr %retptr, align 8
  br label %common.ret

B1770:
  %.1024 = fadd contract double %.422, %h.3.1
  %until.2.1 = select i1 %.441, double %.186, double %.1024
  %.1036 = load i64, ptr %arg.counts, align 8
  %.1046 = icmp slt i64 %.1036, %arg.edge_count
  br i1 %.1046, label %B1826, label %B1908

B1826:
  %.1057 = getelementptr double, ptr %arg.edges, i64 %.1036
  %.1058 = load double, ptr %.1057, align 8
  %.1062 = fmul contract double %until.2.1, 0x3FF0000000000005
  %.1063 = fcmp contract ugt double %.1058, %.1062
  br i1 %.1063, label %B1908, label %B1856

B1856:
  %stop.2.1 = phi i64 [ %.1069, %B1878 ], [ %.1036, %B1826 ]
  %exitcond.not = icmp eq i64 %stop.2.1, %7
  br i1 %exitcond.not, label %B1908, label %B1878

B1878:
  %.1069 = add nsw i64 %stop.2.1, 1
  %.1090 = getelementptr double, ptr %arg.edges, i64 %.1069
  %.1091 = load double, ptr %.1090, align 8
  %.1096 = fcmp contract ugt double %.1091, %.1062
  br i1 %.1096, label %B1908, label %B1856

B1908:
  %stop.3.2 = phi i64 [ %.1036, %B1826 ], [ %.1036, %B1770 ], [ %arg.edge_count, %B1856 ], [ %.1069, %B1878 ]
  %.1113 = icmp sgt i64 %stop.3.2, %.1036
  br i1 %.1113, label %B1942, label %B2156

B1942:
  %.1120 = getelementptr double, ptr %arg.edges, i64 %.1036
  %.1125 = sub nsw i64 %stop.3.2, %.1036
  %.1130 = sub nsw i64 %.1036, %.192
  %.1132 = mul nsw i64 %.1130, %.92
  %.1134 = getelementptr double, ptr %arg.outputs, i64 %.1132
  store ptr null, ptr %.1145, align 8
  %.1149 = call i32 @dense_output.26(ptr nonnull %.1145, ptr nonnull %excinfo.11, i64 %.92, ptr %arg.y, ptr %.112, ptr %arg.work, ptr %arg.method, double %.422, double %until.2.1, ptr %.1120, i64 %.1125, ptr %.1134, ptr %.108, ptr %.129, ptr %.139)
  switch i32 %.1149, label %B1942.if [
    i32 -2, label %B1942.endif
    i32 0, label %B1942.endif
  ]

B2156:
  %.1185 = load double, ptr %.1184, align 8
  %.1188 = load double, ptr %.1187, align 8
  store double 0.000000e+00, ptr %.1191, align 8
  %.1195 = call i32 @step_factor.25(ptr nonnull %.1191, ptr nonnull %excinfo.12, double %error.2.1, double %.1185, double %.1188, ptr %arg.settings)
  %.1205 = load double, ptr %.1191, align 8
  switch i32 %.1195, label %B2156.if [
    i32 -2, label %B2156.endif
    i32 0, label %B2156.endif
  ]

B2494:
  store double 0.000000e+00, ptr %.1410, align 8
  %.1416 = call i32 @numba.28(ptr nonnull %.1410, ptr nonnull %excinfo.15, double %.425266, double %h.3.1)
  %.1426 = load double, ptr %.1410, align 8
  switch i32 %.1416, label %B2494.if [
    i32 -2, label %B2494.endif
    i32 0, label %B2494.endif
  ]

B2622:
  %.1497 = fmul contract double %h.3.1, %.1205
  %.1504 = load double, ptr %.1503, align 8
  store double 0.000000e+00, ptr %.1507, align 8
  %.1513 = call i32 @numba.21(ptr nonnull %.1507, ptr nonnull %excinfo.17, double %.1497, double %.1504)
  switch i32 %.1513, label %B2622.if [
    i32 -2, label %B2622.endif
    i32 0, label %B2622.endif
  ]

B2754:
  store i64 1, ptr %retptr, align 8
  br label %common.ret

B2755:
  %.425267 = phi double [ %.899, %B1570.endif ], [ %.1523, %B2622.endif.endif ]
  %.284 = icmp sgt i64 %.228.0264, 1
  br i1 %.284, label %B672.if, label %B2754

B672.if:
  %.425266 = phi double [ %.424.promoted, %B672.if.lr.ph ], [ %.425267, %B2755 ]
  %fresh.3.0265 = phi i1 [ false, %B672.if.lr.ph ], [ %.851, %B2755 ]
  %.228.0264 = phi i64 [ %arg.max_steps, %B672.if.lr.ph ], [ %.293, %B2755 ]
  %.293 = add nsw i64 %.228.0264, -1
  %.422 = load double, ptr %arg.state, align 8
  %.434 = fsub contract double %.186, %.422
  %.439 = fmul contract double %.434, 0x3FEFFFFFFF768FA1
  %.441 = fcmp contract oge double %.425266, %.439
  br i1 %.441, label %B856, label %B800

B818.endif.if:
  %.499 = icmp sgt i32 %.491, 0
  %.492 = load ptr, ptr %excinfo.1, align 8
  %.500 = select i1 %.499, ptr %.492, ptr undef
  store ptr %.500, ptr %excinfo, align 8
  br label %common.ret

B818.endif.endif:
  %.501 = load double, ptr %.485, align 8
  br label %B856

B860.if:
  %.553 = icmp sgt i32 %.545, 0
  %.546 = load ptr, ptr %excinfo.2, align 8
  %.554 = select i1 %.553, ptr %.546, ptr undef
  store ptr %.554, ptr %excinfo, align 8
  br label %common.ret

B860.endif:
  %.567 = load i64, ptr %.566, align 8
  %.568 = add nsw i64 %.567, 1
  store i64 %.568, ptr %.566, align 8
  br label %B966

B966.endif.if:
  %.606 = icmp sgt i32 %.598, 0
  %.599 = load ptr, ptr %excinfo.3, align 8
  %.607 = select i1 %.606, ptr %.599, ptr undef
  store ptr %.607, ptr %excinfo, align 8
  br label %common.ret

B966.endif.endif:
  store i64 0, ptr %.625, align 8
  %.629 = call i32 @lu_factor.17(ptr nonnull %.625, ptr nonnull %excinfo.4, i64 %arg.blocks, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %.146, ptr %.129)
  switch i32 %.629, label %B966.endif.endif.if [
    i32 -2, label %B966.endif.endif.endif
    i32 0, label %B966.endif.endif.endif
  ]

B966.endif.endif.if:
  %.637 = icmp sgt i32 %.629, 0
  %.630 = load ptr, ptr %excinfo.4, align 8
  %.638 = select i1 %.637, ptr %.630, ptr undef
  store ptr %.638, ptr %excinfo, align 8
  br label %common.ret

B966.endif.endif.endif:
  %.639 = load i64, ptr %.625, align 8
  %.651 = load i64, ptr %.650, align 8
  %.652 = add nsw i64 %.651, 1
  store i64 %.652, ptr %.650, align 8
  %.659 = icmp eq i64 %.639, 0
  br i1 %.659, label %B1176, label %B1558

B1176.if:
  %.699 = icmp sgt i32 %.691, 0
  %.692 = load ptr, ptr %excinfo.5, align 8
  %.700 = select i1 %.699, ptr %.692, ptr undef
  store ptr %.700, ptr %excinfo, align 8
  br label %common.ret

B1176.endif:
  %.713 = load i64, ptr %.712, align 8
  %.714 = add nsw i64 %.713, 8
  store i64 %.714, ptr %.712, align 8
  store ptr null, ptr %.727, align 8
  %.731 = call i32 @copy.27(ptr nonnull %.727, ptr nonnull %excinfo.6, i64 %.92, ptr %.105, ptr %.112)
  switch i32 %.731, label %B1176.endif.if [
    i32 -2, label %B1176.endif.endif
    i32 0, label %B1176.endif.endif
  ]

B1176.endif.if:
  %.739 = icmp sgt i32 %.731, 0
  %.732 = load ptr, ptr %excinfo.6, align 8
  %.740 = select i1 %.739, ptr %.732, ptr undef
  store ptr %.740, ptr %excinfo, align 8
  br label %common.ret

B1176.endif.endif:
  store ptr null, ptr %.754, align 8
  %.758 = call i32 @add_scaled.29(ptr nonnull %.754, ptr nonnull %excinfo.7, i64 %.92, double 1.000000e+00, ptr %.722, ptr %.112)
  switch i32 %.758, label %B1176.endif.endif.if [
    i32 -2, label %B1176.endif.endif.endif
    i32 0, label %B1176.endif.endif.endif
  ]

B1176.endif.endif.if:
  %.766 = icmp sgt i32 %.758, 0
  %.759 = load ptr, ptr %excinfo.7, align 8
  %.767 = select i1 %.766, ptr %.759, ptr undef
  store ptr %.767, ptr %excinfo, align 8
  br label %common.ret

B1176.endif.endif.endif:
  %.780 = load double, ptr %.779, align 8
  %.785 = fdiv contract double %h.3.1, %.780
  store double 0.000000e+00, ptr %.788, align 8
  %.794 = call i32 @numba.21(ptr nonnull %.788, ptr nonnull %excinfo.8, double 1.000000e+00, double %.785)
  switch i32 %.794, label %B1176.endif.endif.endif.endif.if [
    i32 -2, label %B1176.endif.endif.endif.endif.endif
    i32 0, label %B1176.endif.endif.endif.endif.endif
  ]

B1176.endif.endif.endif.endif.if:
  %.802 = icmp sgt i32 %.794, 0
  %.795 = load ptr, ptr %excinfo.8, align 8
  %.803 = select i1 %.802, ptr %.795, ptr undef
  store ptr %.803, ptr %excinfo, align 8
  br label %common.ret

B1176.endif.endif.endif.endif.endif:
  %.804 = load double, ptr %.788, align 8
  %.817 = load double, ptr %arg.settings, align 8
  store double 0.000000e+00, ptr %.823, align 8
  %.827 = call i32 @step_error.30(ptr nonnull %.823, ptr nonnull %excinfo.9, i64 %.92, i64 %arg.tested, ptr %arg.y, ptr %.112, ptr %.722, ptr %arg.powers, double %.804, double %.817)
  switch i32 %.827, label %B1176.endif.endif.endif.endif.endif.if [
    i32 -2, label %B1176.endif.endif.endif.endif.endif.endif
    i32 0, label %B1176.endif.endif.endif.endif.endif.endif
  ]

B1176.endif.endif.endif.endif.endif.if:
  %.835 = icmp sgt i32 %.827, 0
  %.828 = load ptr, ptr %excinfo.9, align 8
  %.836 = select i1 %.835, ptr %.828, ptr undef
  store ptr %.836, ptr %excinfo, align 8
  br label %common.ret

B1176.endif.endif.endif.endif.endif.endif:
  %.837 = load double, ptr %.823, align 8
  br label %B1558

B1570.if:
  %.884 = icmp sgt i32 %.876, 0
  %.877 = load ptr, ptr %excinfo.10, align 8
  %.885 = select i1 %.884, ptr %.877, ptr undef
  store ptr %.885, ptr %excinfo, align 8
  br label %common.ret

B1570.endif:
  %.886 = load double, ptr %.872, align 8
  %.899 = fmul contract double %h.3.1, %.886
  store double %.899, ptr %.424, align 8
  %.910 = load double, ptr %.909, align 8
  %.911 = fcmp contract olt double %.899, %.910
  br i1 %.911, label %B1748, label %B2755

B1942.if:
  %.1157 = icmp sgt i32 %.1149, 0
  %.1150 = load ptr, ptr %excinfo.11, align 8
  %.1158 = select i1 %.1157, ptr %.1150, ptr undef
  store ptr %.1158, ptr %excinfo, align 8
  br label %common.ret

B1942.endif:
  store i64 %stop.3.2, ptr %arg.counts, align 8
  br label %B2156

B2156.if:
  %.1203 = icmp sgt i32 %.1195, 0
  %.1196 = load ptr, ptr %excinfo.12, align 8
  %.1204 = select i1 %.1203, ptr %.1196, ptr undef
  store ptr %.1204, ptr %excinfo, align 8
  br label %common.ret

B2156.endif:
  store ptr null, ptr %.1284, align 8
  %.1288 = call i32 @copy.27(ptr nonnull %.1284, ptr nonnull %excinfo.14, i64 %.92, ptr %.112, ptr %arg.y)
  switch i32 %.1288, label %B2436.if [
    i32 -2, label %B2436.endif
    i32 0, label %B2436.endif
  ]

B2436.if:
  %.1296 = icmp sgt i32 %.1288, 0
  %.1289 = load ptr, ptr %excinfo.14, align 8
  %.1297 = select i1 %.1296, ptr %.1289, ptr undef
  store ptr %.1297, ptr %excinfo, align 8
  br label %common.ret

B2436.endif:
  store double %until.2.1, ptr %arg.state, align 8
  br i1 %.441, label %B2494, label %B2622

B2494.if:
  %.1424 = icmp sgt i32 %.1416, 0
  %.1417 = load ptr, ptr %excinfo.15, align 8
  %.1425 = select i1 %.1424, ptr %.1417, ptr undef
  store ptr %.1425, ptr %excinfo, align 8
  br label %common.ret

B2494.endif:
  %.1441 = getelementptr i8, ptr %arg.settings, i64 32
  %.1442 = load double, ptr %.1441, align 8
  %.1448 = fdiv contract double 1.000000e+00, %.1442
  store double 0.000000e+00, ptr %.1452, align 8
  %.1458 = call i32 @numba.21(ptr nonnull %.1452, ptr nonnull %excinfo.16, double %.1205, double %.1448)
  switch i32 %.1458, label %B2494.endif.endif.if [
    i32 -2, label %B2494.endif.endif.endif
    i32 0, label %B2494.endif.endif.endif
  ]

B2494.endif.endif.if:
  %.1466 = icmp sgt i32 %.1458, 0
  %.1459 = load ptr, ptr %excinfo.16, align 8
  %.1467 = select i1 %.1466, ptr %.1459, ptr undef
  store ptr %.1467, ptr %excinfo, align 8
  br label %common.ret

B2494.endif.endif.endif:
  %.1468 = load double, ptr %.1452, align 8
  %.1480 = fmul contract double %.1426, %.1468
  store double %.1480, ptr %.424, align 8
  store i64 0, ptr %retptr, align 8
  br label %common.ret

B2622.if:
  %.1521 = icmp sgt i32 %.1513, 0
  %.1514 = load ptr, ptr %excinfo.17, align 8
  %.1522 = select i1 %.1521, ptr %.1514, ptr undef
  store ptr %.1522, ptr %excinfo, align 8
  br label %common.ret

B2622.endif:
  %.1523 = load double, ptr %.1507, align 8
  store double %.1523, ptr %.424, align 8
  store double 0.000000e+00, ptr %.1539, align 8
  %.1545 = call i32 @numba.28(ptr nonnull %.1539, ptr nonnull %excinfo.18, double %error.2.1, double 1.000000e-04)
  switch i32 %.1545, label %B2622.endif.if [
    i32 -2, label %B2622.endif.endif
    i32 0, label %B2622.endif.endif
  ]

B2622.endif.if:
  %.1553 = icmp sgt i32 %.1545, 0
  %.1546 = load ptr, ptr %excinfo.18, align 8
  %.1554 = select i1 %.1553, ptr %.1546, ptr undef
  store ptr %.1554, ptr %excinfo, align 8
  br label %common.ret

B2622.endif.endif:
  %.1555 = load double, ptr %.1539, align 8
  store double %.1555, ptr %.1184, align 8
  br label %B2755
}

define i64 @lu_solve_transposed(i64 %a0, ptr %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @lu_solve_transposed.35(ptr nonnull %r, ptr nonnull %e, i64 %a0, ptr %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9)
  ret i64 0
}

define internal i32 @lu_solve_transposed.35(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.slots, i64 %arg.blocks, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.lu, ptr noalias %arg.right, ptr noalias %arg.solution, ptr noalias %arg.x) noinline {
entry:
  %0 = call i64 @llvm.smax.i64(i64 %arg.blocks, i64 0)
  %storemerge = shl nuw i64 %0, 1
  %.117249 = icmp sgt i64 %storemerge, 0
  br i1 %.117249, label %B40.if.preheader, label %B56

B40.if.preheader:
  %1 = shl i64 %0, 4
  call void @llvm.memset.p0.i64(ptr align 8 %arg.x, i8 0, i64 %1, i1 false)
  br label %B56

B56:
  %.243252.not = icmp slt i64 %arg.n, 1
  br i1 %.243252.not, label %B126, label %B86.if

B126:
  %.379258.not = icmp slt i64 %arg.blocks, 1
  br i1 %.379258.not, label %B698, label %B158.if

B156.loopexit:
  %exitcond271.not = icmp eq i64 %arg.blocks, %.392
  br i1 %exitcond271.not, label %B698, label %B158.if

B698:
  %.748265.not = icmp slt i64 %arg.blocks, 1
  br i1 %.748265.not, label %B1090.preheader, label %B738.if

B738.loopexit:
  %.748 = icmp sgt i64 %.695.0266, 1
  br i1 %.748, label %B738.if, label %B1090.preheader

B1090.preheader:
  %.1076268.not = icmp slt i64 %arg.n, 1
  br i1 %.1076268.not, label %B1130, label %B1090.if

B1130:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B86.if:
  %.187.0253 = phi i64 [ %.256, %B86.if ], [ 0, %B56 ]
  %.256 = add nuw nsw i64 %.187.0253, 1
  %.282 = getelementptr double, ptr %arg.right, i64 %.187.0253
  %.283 = load double, ptr %.282, align 8
  %.285 = getelementptr i32, ptr %arg.slots, i64 %.187.0253
  %.286 = load i32, ptr %.285, align 4
  %.288 = sext i32 %.286 to i64
  %.289 = getelementptr double, ptr %arg.x, i64 %.288
  store double %.283, ptr %.289, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.256
  br i1 %exitcond.not, label %B126, label %B86.if

B158.if:
  %.322.0259 = phi i64 [ %.392, %B156.loopexit ], [ 0, %B126 ]
  %.392 = add nuw nsw i64 %.322.0259, 1
  %.418 = getelementptr i32, ptr %arg.diagonal, i64 %.322.0259
  %.419 = load i32, ptr %.418, align 4
  %.420 = sext i32 %.419 to i64
  %.423.idx = shl nsw i64 %.420, 5
  %.423 = getelementptr i8, ptr %arg.lu, i64 %.423.idx
  %.424 = load double, ptr %.423, align 8
  %.427.idx = shl i64 %.322.0259, 4
  %.427 = getelementptr i8, ptr %arg.x, i64 %.427.idx
  %.428 = load double, ptr %.427, align 8
  %.429 = fmul contract double %.424, %.428
  %.432 = getelementptr i8, ptr %.423, i64 16
  %.433 = load double, ptr %.432, align 8
  %.437 = getelementptr i8, ptr %.427, i64 8
  %.438 = load double, ptr %.437, align 8
  %.439 = fmul contract double %.433, %.438
  %.440 = fadd contract double %.429, %.439
  %.446 = getelementptr i8, ptr %.423, i64 8
  %.447 = load double, ptr %.446, align 8
  %.452 = fmul contract double %.428, %.447
  %.455 = getelementptr i8, ptr %.423, i64 24
  %.456 = load double, ptr %.455, align 8
  %.462 = fmul contract double %.438, %.456
  %.463 = fadd contract double %.452, %.462
  store double %.440, ptr %.427, align 8
  store double %.463, ptr %.437, align 8
  %.482 = add nsw i64 %.420, 1
  %2 = getelementptr i32, ptr %arg.lu_start, i64 %.322.0259
  %.485 = getelementptr i8, ptr %2, i64 4
  %.486 = load i32, ptr %.485, align 4
  %.487 = sext i32 %.486 to i64
  %.524 = sub nsw i64 %.487, %.482
  %.567255.not = icmp slt i64 %.524, 1
  br i1 %.567255.not, label %B156.loopexit, label %B484.if

B484.if:
  %.514.0257 = phi i64 [ %.576, %B484.if ], [ %.524, %B158.if ]
  %.511.0256 = phi i64 [ %.580, %B484.if ], [ %.482, %B158.if ]
  %.576 = add nsw i64 %.514.0257, -1
  %.580 = add nsw i64 %.511.0256, 1
  %.607 = getelementptr i32, ptr %arg.lu_columns, i64 %.511.0256
  %.608 = load i32, ptr %.607, align 4
  %.609 = sext i32 %.608 to i64
  %.612.idx = shl nsw i64 %.609, 4
  %.612 = getelementptr i8, ptr %arg.x, i64 %.612.idx
  %.613 = load double, ptr %.612, align 8
  %.615.idx = shl i64 %.511.0256, 5
  %.615 = getelementptr i8, ptr %arg.lu, i64 %.615.idx
  %.616 = load double, ptr %.615, align 8
  %.618 = fmul contract double %.440, %.616
  %.621 = getelementptr i8, ptr %.615, i64 16
  %.622 = load double, ptr %.621, align 8
  %.624 = fmul contract double %.463, %.622
  %.625 = fadd contract double %.618, %.624
  %.626 = fsub contract double %.613, %.625
  store double %.626, ptr %.612, align 8
  %.632 = getelementptr i8, ptr %.612, i64 8
  %.633 = load double, ptr %.632, align 8
  %.636 = getelementptr i8, ptr %.615, i64 8
  %.637 = load double, ptr %.636, align 8
  %.639 = fmul contract double %.440, %.637
  %.642 = getelementptr i8, ptr %.615, i64 24
  %.643 = load double, ptr %.642, align 8
  %.645 = fmul contract double %.463, %.643
  %.646 = fadd contract double %.639, %.645
  %.647 = fsub contract double %.633, %.646
  store double %.647, ptr %.632, align 8
  %.567 = icmp sgt i64 %.514.0257, 1
  br i1 %.567, label %B484.if, label %B156.loopexit

B738.if:
  %.692.0267.in = phi i64 [ %.692.0267, %B738.loopexit ], [ %arg.blocks, %B698 ]
  %.695.0266 = phi i64 [ %.757, %B738.loopexit ], [ %arg.blocks, %B698 ]
  %.692.0267 = add i64 %.692.0267.in, -1
  %.757 = add nsw i64 %.695.0266, -1
  %.788.idx = shl i64 %.692.0267, 4
  %.788 = getelementptr i8, ptr %arg.x, i64 %.788.idx
  %.789 = load double, ptr %.788, align 8
  %.793 = getelementptr i8, ptr %.788, i64 8
  %.794 = load double, ptr %.793, align 8
  %.802 = getelementptr i32, ptr %arg.lu_start, i64 %.692.0267
  %.803 = load i32, ptr %.802, align 4
  %.805 = getelementptr i32, ptr %arg.diagonal, i64 %.692.0267
  %.806 = load i32, ptr %.805, align 4
  %.843 = sub i32 %.806, %.803
  %.886261.not = icmp slt i32 %.843, 1
  br i1 %.886261.not, label %B738.loopexit, label %B848.if

B848.if:
  %.833.0263 = phi i32 [ %.895, %B848.if ], [ %.843, %B738.if ]
  %.830.0262 = phi i32 [ %.899, %B848.if ], [ %.803, %B738.if ]
  %.895 = add nsw i32 %.833.0263, -1
  %.899 = add i32 %.830.0262, 1
  %3 = sext i32 %.830.0262 to i64
  %.928 = getelementptr i32, ptr %arg.lu_columns, i64 %3
  %.929 = load i32, ptr %.928, align 4
  %.930 = sext i32 %.929 to i64
  %.933.idx = shl nsw i64 %.930, 4
  %.933 = getelementptr i8, ptr %arg.x, i64 %.933.idx
  %.934 = load double, ptr %.933, align 8
  %.936.idx = shl nsw i64 %3, 5
  %.936 = getelementptr i8, ptr %arg.lu, i64 %.936.idx
  %.937 = load double, ptr %.936, align 8
  %.939 = fmul contract double %.789, %.937
  %.942 = getelementptr i8, ptr %.936, i64 16
  %.943 = load double, ptr %.942, align 8
  %.945 = fmul contract double %.794, %.943
  %.946 = fadd contract double %.939, %.945
  %.947 = fsub contract double %.934, %.946
  store double %.947, ptr %.933, align 8
  %.953 = getelementptr i8, ptr %.933, i64 8
  %.954 = load double, ptr %.953, align 8
  %.957 = getelementptr i8, ptr %.936, i64 8
  %.958 = load double, ptr %.957, align 8
  %.960 = fmul contract double %.789, %.958
  %.963 = getelementptr i8, ptr %.936, i64 24
  %.964 = load double, ptr %.963, align 8
  %.966 = fmul contract double %.794, %.964
  %.967 = fadd contract double %.960, %.966
  %.968 = fsub contract double %.954, %.967
  store double %.968, ptr %.953, align 8
  %.886 = icmp sgt i32 %.833.0263, 1
  br i1 %.886, label %B848.if, label %B738.loopexit

B1090.if:
  %.1020.0269 = phi i64 [ %.1089, %B1090.if ], [ 0, %B1090.preheader ]
  %.1089 = add nuw nsw i64 %.1020.0269, 1
  %.1115 = getelementptr i32, ptr %arg.slots, i64 %.1020.0269
  %.1116 = load i32, ptr %.1115, align 4
  %.1118 = sext i32 %.1116 to i64
  %.1119 = getelementptr double, ptr %arg.x, i64 %.1118
  %.1120 = load double, ptr %.1119, align 8
  %.1122 = getelementptr double, ptr %arg.solution, i64 %.1020.0269
  store double %.1120, ptr %.1122, align 8
  %exitcond272.not = icmp eq i64 %arg.n, %.1089
  br i1 %exitcond272.not, label %B1130, label %B1090.if
}

define i64 @lu_solve_sides(i64 %a0, ptr %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @lu_solve_sides.36(ptr nonnull %r, ptr nonnull %e, i64 %a0, ptr %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9)
  ret i64 0
}

define internal i32 @lu_solve_sides.36(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.slots, i64 %arg.blocks, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.lu, ptr noalias %arg.right, ptr noalias %arg.solution, ptr noalias %arg.x) noinline {
entry:
  %.691 = alloca ptr, align 8
  store ptr null, ptr %.691, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.999 = alloca ptr, align 8
  store ptr null, ptr %.999, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %0 = call i64 @llvm.smax.i64(i64 %arg.blocks, i64 0)
  %storemerge = shl i64 %0, 4
  %.118375 = icmp sgt i64 %storemerge, 0
  br i1 %.118375, label %B56.if.preheader, label %B72

B56.if.preheader:
  %1 = shl i64 %0, 7
  call void @llvm.memset.p0.i64(ptr align 8 %arg.x, i8 0, i64 %1, i1 false)
  br label %B72

B72:
  %.244380.not = icmp slt i64 %arg.n, 1
  br i1 %.244380.not, label %B232, label %B102.if

B232:
  %.512386.not = icmp slt i64 %arg.blocks, 1
  br i1 %.512386.not, label %B434, label %B262.if

B262.loopexit:
  %exitcond405.not = icmp eq i64 %arg.blocks, %.525
  br i1 %exitcond405.not, label %B434, label %B262.if

B434:
  %.810395.not = icmp slt i64 %arg.blocks, 1
  br i1 %.810395.not, label %B988.preheader, label %B474.if

B474.loopexit:
  %.810 = icmp sgt i64 %.757.0396, 1
  br i1 %.810, label %B474.if, label %B988.preheader

B988.preheader:
  %.1328400.not = icmp slt i64 %arg.n, 1
  br i1 %.1328400.not, label %B1118, label %B988.if

B678:
  %.1030.idx = shl nsw i64 %.853, 5
  %.1030 = getelementptr i8, ptr %arg.lu, i64 %.1030.idx
  %.1031 = load double, ptr %.1030, align 8
  %.1035 = getelementptr i8, ptr %.1030, i64 8
  %.1036 = load double, ptr %.1035, align 8
  %.1040 = getelementptr i8, ptr %.1030, i64 16
  %.1041 = load double, ptr %.1040, align 8
  %.1047 = getelementptr i8, ptr %.1030, i64 24
  %.1048 = load double, ptr %.1047, align 8
  %2 = getelementptr double, ptr %arg.x, i64 %.849
  %3 = getelementptr i8, ptr %2, i64 64
  br label %B806.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B1118 ], [ %.1003, %B596.if ], [ %.695, %B350.if ]
  ret i32 %common.ret.op

B1118:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B102.if:
  %.188.0381 = phi i64 [ %.257, %B102.if ], [ 0, %B72 ]
  %4 = shl i64 %.188.0381, 6
  %scevgep = getelementptr i8, ptr %arg.right, i64 %4
  %.410 = getelementptr i32, ptr %arg.slots, i64 %.188.0381
  %.411 = load i32, ptr %.410, align 4
  %.412 = sext i32 %.411 to i64
  %.idx374 = shl nsw i64 %.412, 6
  %5 = getelementptr i8, ptr %arg.x, i64 %.idx374
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 dereferenceable(64) %5, ptr nonnull align 8 dereferenceable(64) %scevgep, i64 64, i1 false)
  %.257 = add nuw nsw i64 %.188.0381, 1
  %exitcond.not = icmp eq i64 %arg.n, %.257
  br i1 %exitcond.not, label %B232, label %B102.if

B262.if:
  %.456.0387 = phi i64 [ %.525, %B262.loopexit ], [ 0, %B232 ]
  %.525 = add nuw nsw i64 %.456.0387, 1
  %.551 = shl nsw i64 %.456.0387, 4
  %.556 = getelementptr i32, ptr %arg.lu_start, i64 %.456.0387
  %.557 = load i32, ptr %.556, align 4
  %.559 = getelementptr i32, ptr %arg.diagonal, i64 %.456.0387
  %.560 = load i32, ptr %.559, align 4
  %.597 = sub i32 %.560, %.557
  %.640383.not = icmp slt i32 %.597, 1
  br i1 %.640383.not, label %B262.loopexit, label %B348.if

B348.if:
  %.587.0385 = phi i32 [ %.649, %B350.endif ], [ %.597, %B262.if ]
  %.584.0384 = phi i32 [ %.653, %B350.endif ], [ %.557, %B262.if ]
  %6 = sext i32 %.584.0384 to i64
  %.680 = shl nsw i64 %6, 2
  %.683 = getelementptr i32, ptr %arg.lu_columns, i64 %6
  %.684 = load i32, ptr %.683, align 4
  %.685 = sext i32 %.684 to i64
  %.687 = shl nsw i64 %.685, 4
  store ptr null, ptr %.691, align 8
  %.695 = call i32 @subtract_product.37(ptr nonnull %.691, ptr nonnull %excinfo.1, ptr %arg.lu, i64 %.680, ptr %arg.x, i64 %.687, i64 %.551)
  switch i32 %.695, label %B350.if [
    i32 -2, label %B350.endif
    i32 0, label %B350.endif
  ]

B350.if:
  %.703 = icmp sgt i32 %.695, 0
  %.696 = load ptr, ptr %excinfo.1, align 8
  %.704 = select i1 %.703, ptr %.696, ptr undef
  store ptr %.704, ptr %excinfo, align 8
  br label %common.ret

B350.endif:
  %.653 = add i32 %.584.0384, 1
  %.649 = add nsw i32 %.587.0385, -1
  %.640 = icmp sgt i32 %.587.0385, 1
  br i1 %.640, label %B348.if, label %B262.loopexit

B474.if:
  %.754.0397.in = phi i64 [ %.754.0397, %B474.loopexit ], [ %arg.blocks, %B434 ]
  %.757.0396 = phi i64 [ %.819, %B474.loopexit ], [ %arg.blocks, %B434 ]
  %.754.0397 = add i64 %.754.0397.in, -1
  %.819 = add nsw i64 %.757.0396, -1
  %.849 = shl nsw i64 %.754.0397, 4
  %.851 = getelementptr i32, ptr %arg.diagonal, i64 %.754.0397
  %.852 = load i32, ptr %.851, align 4
  %.853 = sext i32 %.852 to i64
  %.865 = add nsw i64 %.853, 1
  %7 = getelementptr i32, ptr %arg.lu_start, i64 %.754.0397
  %.868 = getelementptr i8, ptr %7, i64 4
  %.869 = load i32, ptr %.868, align 4
  %.870 = sext i32 %.869 to i64
  %.907 = sub nsw i64 %.870, %.865
  %.950389.not = icmp slt i64 %.907, 1
  br i1 %.950389.not, label %B678, label %B594.if

B594.if:
  %.897.0391 = phi i64 [ %.959, %B596.endif ], [ %.907, %B474.if ]
  %.894.0390 = phi i64 [ %.963, %B596.endif ], [ %.865, %B474.if ]
  %.989 = shl nsw i64 %.894.0390, 2
  %.991 = getelementptr i32, ptr %arg.lu_columns, i64 %.894.0390
  %.992 = load i32, ptr %.991, align 4
  %.993 = sext i32 %.992 to i64
  %.995 = shl nsw i64 %.993, 4
  store ptr null, ptr %.999, align 8
  %.1003 = call i32 @subtract_product.37(ptr nonnull %.999, ptr nonnull %excinfo.2, ptr %arg.lu, i64 %.989, ptr %arg.x, i64 %.995, i64 %.849)
  switch i32 %.1003, label %B596.if [
    i32 -2, label %B596.endif
    i32 0, label %B596.endif
  ]

B596.if:
  %.1011 = icmp sgt i32 %.1003, 0
  %.1004 = load ptr, ptr %excinfo.2, align 8
  %.1012 = select i1 %.1011, ptr %.1004, ptr undef
  store ptr %.1012, ptr %excinfo, align 8
  br label %common.ret

B596.endif:
  %.963 = add nsw i64 %.894.0390, 1
  %.959 = add nsw i64 %.897.0391, -1
  %.950 = icmp sgt i64 %.897.0391, 1
  br i1 %.950, label %B594.if, label %B678

B806.if:
  %.1092.0392 = phi i64 [ 0, %B678 ], [ %.1161, %B806.if ]
  %.1161 = add nuw nsw i64 %.1092.0392, 1
  %.1189 = getelementptr double, ptr %2, i64 %.1092.0392
  %.1190 = load double, ptr %.1189, align 8
  %.1195 = getelementptr double, ptr %3, i64 %.1092.0392
  %.1196 = load double, ptr %.1195, align 8
  %.1198 = fmul contract double %.1031, %.1190
  %.1200 = fmul contract double %.1036, %.1196
  %.1201 = fadd contract double %.1198, %.1200
  store double %.1201, ptr %.1189, align 8
  %.1208 = fmul contract double %.1041, %.1190
  %.1210 = fmul contract double %.1048, %.1196
  %.1211 = fadd contract double %.1208, %.1210
  store double %.1211, ptr %.1195, align 8
  %exitcond406.not = icmp eq i64 %.1161, 8
  br i1 %exitcond406.not, label %B474.loopexit, label %B806.if

B988.if:
  %.1272.0401 = phi i64 [ %.1341, %B988.if ], [ 0, %B988.preheader ]
  %8 = shl i64 %.1272.0401, 6
  %scevgep407 = getelementptr i8, ptr %arg.solution, i64 %8
  %.1488 = getelementptr i32, ptr %arg.slots, i64 %.1272.0401
  %.1489 = load i32, ptr %.1488, align 4
  %.1490 = sext i32 %.1489 to i64
  %.idx = shl nsw i64 %.1490, 6
  %9 = getelementptr i8, ptr %arg.x, i64 %.idx
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 dereferenceable(64) %scevgep407, ptr nonnull align 8 dereferenceable(64) %9, i64 64, i1 false)
  %.1341 = add nuw nsw i64 %.1272.0401, 1
  %exitcond408.not = icmp eq i64 %arg.n, %.1341
  br i1 %exitcond408.not, label %B1118, label %B988.if
}

define internal i32 @subtract_product.37(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.lu, i64 %arg.block, ptr noalias %arg.x, i64 %arg.source, i64 %arg.target) {
entry:
  %.15 = getelementptr double, ptr %arg.lu, i64 %arg.block
  %.16 = load double, ptr %.15, align 8
  %.18 = getelementptr i8, ptr %.15, i64 8
  %.19 = load double, ptr %.18, align 8
  %.21 = getelementptr i8, ptr %.15, i64 16
  %.22 = load double, ptr %.21, align 8
  %.24 = getelementptr i8, ptr %.15, i64 24
  %.25 = load double, ptr %.24, align 8
  %0 = getelementptr double, ptr %arg.x, i64 %arg.source
  %1 = getelementptr i8, ptr %0, i64 64
  %2 = getelementptr double, ptr %arg.x, i64 %arg.target
  %3 = getelementptr i8, ptr %2, i64 64
  br label %B132.if

B326:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B132.if:
  %.69.038 = phi i64 [ 0, %entry ], [ %.140, %B132.if ]
  %.140 = add nuw nsw i64 %.69.038, 1
  %.168 = getelementptr double, ptr %0, i64 %.69.038
  %.169 = load double, ptr %.168, align 8
  %.174 = getelementptr double, ptr %1, i64 %.69.038
  %.175 = load double, ptr %.174, align 8
  %.179 = getelementptr double, ptr %2, i64 %.69.038
  %.180 = load double, ptr %.179, align 8
  %.182 = fmul contract double %.16, %.169
  %.184 = fmul contract double %.19, %.175
  %.185 = fadd contract double %.182, %.184
  %.186 = fsub contract double %.180, %.185
  store double %.186, ptr %.179, align 8
  %.194 = getelementptr double, ptr %3, i64 %.69.038
  %.195 = load double, ptr %.194, align 8
  %.197 = fmul contract double %.22, %.169
  %.199 = fmul contract double %.25, %.175
  %.200 = fadd contract double %.197, %.199
  %.201 = fsub contract double %.195, %.200
  store double %.201, ptr %.194, align 8
  %exitcond.not = icmp eq i64 %.140, 8
  br i1 %exitcond.not, label %B326, label %B132.if
}

define i64 @slopes_at(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @slopes_at.38(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12)
  ret i64 0
}

define internal i32 @slopes_at.38(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.weights, ptr noalias %arg.Y_bar, ptr noalias %arg.numbers_bar, ptr noalias %arg.drive_weights, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.18 = alloca ptr, align 8
  store ptr null, ptr %.18, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.45 = alloca ptr, align 8
  store ptr null, ptr %.45, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.70 = alloca ptr, align 8
  store ptr null, ptr %.70, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  store ptr null, ptr %.18, align 8
  %.22 = call i32 @drive.6(ptr nonnull %.18, ptr nonnull %excinfo.1, ptr %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.local, ptr %arg.out)
  switch i32 %.22, label %B0.if [
    i32 -2, label %B0.endif
    i32 0, label %B0.endif
  ]

B0.if:
  %.30 = icmp sgt i32 %.22, 0
  %.23 = load ptr, ptr %excinfo.1, align 8
  %.31 = select i1 %.30, ptr %.23, ptr undef
  store ptr %.31, ptr %excinfo, align 8
  br label %common.ret

B0.endif:
  store ptr null, ptr %.45, align 8
  %.49 = call i32 @pull_residual.39(ptr nonnull %.45, ptr nonnull %excinfo.2, ptr %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.weights, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %arg.local, ptr %arg.out)
  switch i32 %.49, label %B0.endif.if [
    i32 -2, label %B0.endif.endif
    i32 0, label %B0.endif.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ %.49, %B0.endif.if ], [ %.22, %B0.if ], [ 0, %B0.endif.endif.endif ], [ %.74, %B0.endif.endif.if ]
  ret i32 %common.ret.op

B0.endif.if:
  %.57 = icmp sgt i32 %.49, 0
  %.50 = load ptr, ptr %excinfo.2, align 8
  %.58 = select i1 %.57, ptr %.50, ptr undef
  store ptr %.58, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif:
  store ptr null, ptr %.70, align 8
  %.74 = call i32 @drives_bar.40(ptr nonnull %.70, ptr nonnull %excinfo.3, ptr %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %arg.drive_weights, ptr %arg.local, ptr %arg.out)
  switch i32 %.74, label %B0.endif.endif.if [
    i32 -2, label %B0.endif.endif.endif
    i32 0, label %B0.endif.endif.endif
  ]

B0.endif.endif.if:
  %.82 = icmp sgt i32 %.74, 0
  %.75 = load ptr, ptr %excinfo.3, align 8
  %.83 = select i1 %.82, ptr %.75, ptr undef
  store ptr %.83, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif:
  store ptr null, ptr %retptr, align 8
  br label %common.ret
}

define internal i32 @pull_residual.39(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.weights, ptr noalias %arg.Y_bar, ptr noalias %arg.numbers_bar, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.415 = alloca ptr, align 8
  store ptr null, ptr %.415, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.38 = getelementptr i8, ptr %arg.layout, i64 32
  %.39 = load i64, ptr %.38, align 8
  %.12287.not = icmp slt i64 %.39, 1
  br i1 %.12287.not, label %B730, label %B58.if

B148:
  %.175 = getelementptr i8, ptr %2, i64 56
  %.176 = load i64, ptr %.175, align 8
  %.183 = getelementptr i8, ptr %2, i64 48
  %.184 = load i64, ptr %.183, align 8
  %.186 = getelementptr i32, ptr %arg.idx, i64 %.184
  %.190 = getelementptr i8, ptr %2, i64 64
  %.191 = load i64, ptr %.190, align 8
  %.193 = getelementptr i32, ptr %arg.rows, i64 %.191
  %.203 = getelementptr i8, ptr %2, i64 8
  %.204 = load i64, ptr %.203, align 8
  %.211 = load i64, ptr %2, align 8
  %.212 = mul nsw i64 %.211, %.204
  %.29284.not = icmp slt i64 %.212, 1
  br i1 %.29284.not, label %B731, label %B392.if

B586:
  %.395 = getelementptr i8, ptr %2, i64 32
  %.396 = load i64, ptr %.395, align 8
  %.400 = getelementptr i8, ptr %2, i64 64
  %.401 = load i64, ptr %.400, align 8
  %.403 = getelementptr i32, ptr %arg.rows, i64 %.401
  store ptr null, ptr %.415, align 8
  %.419 = call i32 @pull.41(ptr nonnull %.415, ptr nonnull %excinfo.1, ptr %arg.layout, i64 %1, i64 0, i64 %.396, ptr %.403, ptr %arg.derived, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.weights, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %arg.local, ptr %arg.out)
  switch i32 %.419, label %B586.if [
    i32 -2, label %B731
    i32 0, label %B731
  ]

common.ret:
  %common.ret.op = phi i32 [ 0, %B730 ], [ %.419, %B586.if ]
  ret i32 %common.ret.op

B730:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B731:
  %exitcond90.not = icmp eq i64 %.39, %.135
  br i1 %exitcond90.not, label %B730, label %B58.if

B58.if:
  %.63.088 = phi i64 [ %.135, %B731 ], [ 0, %entry ]
  %.135 = add nuw nsw i64 %.63.088, 1
  %0 = mul nuw nsw i64 %.63.088, 11
  %1 = add nuw nsw i64 %0, 8
  %2 = getelementptr i64, ptr %arg.layout, i64 %1
  %.168 = getelementptr i8, ptr %2, i64 80
  %.169 = load i64, ptr %.168, align 8
  %.170 = icmp eq i64 %.169, -1
  br i1 %.170, label %B148, label %B586

B392.if:
  %.236.085 = phi i64 [ %.305, %B392.if ], [ 0, %B148 ]
  %.305 = add nuw nsw i64 %.236.085, 1
  %.331 = getelementptr i32, ptr %.186, i64 %.236.085
  %.332 = load i32, ptr %.331, align 4
  %.334 = sext i32 %.332 to i64
  %.335 = getelementptr double, ptr %arg.Y_bar, i64 %.334
  %.336 = load double, ptr %.335, align 8
  %.338 = add nsw i64 %.236.085, %.176
  %.340 = getelementptr double, ptr %arg.numbers, i64 %.338
  %.341 = load double, ptr %.340, align 8
  %.343 = getelementptr i32, ptr %.193, i64 %.236.085
  %.344 = load i32, ptr %.343, align 4
  %.346 = sext i32 %.344 to i64
  %.347 = getelementptr double, ptr %arg.weights, i64 %.346
  %.348 = load double, ptr %.347, align 8
  %.349 = fmul contract double %.341, %.348
  %.350 = fadd contract double %.336, %.349
  store double %.350, ptr %.335, align 8
  %.358 = getelementptr double, ptr %arg.numbers_bar, i64 %.338
  %.359 = load double, ptr %.358, align 8
  %.365 = getelementptr double, ptr %arg.Y, i64 %.334
  %.366 = load double, ptr %.365, align 8
  %.374 = fmul contract double %.348, %.366
  %.375 = fadd contract double %.359, %.374
  store double %.375, ptr %.358, align 8
  %exitcond.not = icmp eq i64 %.212, %.305
  br i1 %exitcond.not, label %B731, label %B392.if

B586.if:
  %.427 = icmp sgt i32 %.419, 0
  %.420 = load ptr, ptr %excinfo.1, align 8
  %.428 = select i1 %.427, ptr %.420, ptr undef
  store ptr %.428, ptr %excinfo, align 8
  br label %common.ret
}

define internal i32 @drives_bar.40(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.Y_bar, ptr noalias %arg.numbers_bar, ptr noalias %arg.weights, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.198 = alloca ptr, align 8
  store ptr null, ptr %.198, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.44 = getelementptr i8, ptr %arg.layout, i64 8
  %.45 = load i64, ptr %.44, align 8
  %.12737.not = icmp slt i64 %.45, 1
  br i1 %.12737.not, label %B116, label %B82.if.lr.ph

B82.if.lr.ph:
  %.39 = load i64, ptr %arg.layout, align 8
  %0 = getelementptr double, ptr %arg.Y_bar, i64 %.39
  %1 = shl nuw i64 %.45, 3
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %arg.weights, ptr align 8 %0, i64 %1, i1 false)
  br label %B116

B116:
  %.184 = getelementptr double, ptr %arg.weights, i64 %.45
  store double 0.000000e+00, ptr %.184, align 8
  store ptr null, ptr %.198, align 8
  %.202 = call i32 @pull_drive.42(ptr nonnull %.198, ptr nonnull %excinfo.1, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, i64 0, ptr %arg.weights, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %arg.local, ptr %arg.out)
  switch i32 %.202, label %B116.if [
    i32 -2, label %B116.endif
    i32 0, label %B116.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ %.202, %B116.if ], [ 0, %B116.endif ]
  ret i32 %common.ret.op

B116.if:
  %.210 = icmp sgt i32 %.202, 0
  %.203 = load ptr, ptr %excinfo.1, align 8
  %.211 = select i1 %.210, ptr %.203, ptr undef
  store ptr %.211, ptr %excinfo, align 8
  br label %common.ret

B116.endif:
  store ptr null, ptr %retptr, align 8
  br label %common.ret
}

define internal i32 @pull_drive.42(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, i64 %arg.which, ptr noalias %arg.weights, ptr noalias %arg.Y_bar, ptr noalias %arg.numbers_bar, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.190 = alloca ptr, align 8
  store ptr null, ptr %.190, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.41 = getelementptr i8, ptr %arg.layout, i64 40
  %.42 = load i64, ptr %.41, align 8
  %.12436.not = icmp slt i64 %.42, 1
  br i1 %.12436.not, label %B266, label %B56.if.lr.ph

B56.if.lr.ph:
  %.163 = getelementptr i8, ptr %arg.layout, i64 32
  br label %B56.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B266 ], [ %.194, %B58.if ]
  ret i32 %common.ret.op

B266:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B56.if:
  %.66.037 = phi i64 [ 0, %B56.if.lr.ph ], [ %.137, %B58.endif ]
  %.164 = load i64, ptr %.163, align 8
  %.165 = add nsw i64 %.164, %.66.037
  %.166 = mul nsw i64 %.165, 11
  %.167 = add nsw i64 %.166, 8
  %0 = getelementptr i64, ptr %arg.layout, i64 %.166
  %.171 = getelementptr i8, ptr %0, i64 96
  %.172 = load i64, ptr %.171, align 8
  %.175 = getelementptr i8, ptr %0, i64 128
  %.176 = load i64, ptr %.175, align 8
  %.178 = getelementptr i32, ptr %arg.rows, i64 %.176
  store ptr null, ptr %.190, align 8
  %.194 = call i32 @pull.41(ptr nonnull %.190, ptr nonnull %excinfo.1, ptr %arg.layout, i64 %.167, i64 %arg.which, i64 %.172, ptr %.178, ptr %arg.derived, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.weights, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %arg.local, ptr %arg.out)
  switch i32 %.194, label %B58.if [
    i32 -2, label %B58.endif
    i32 0, label %B58.endif
  ]

B58.if:
  %.202 = icmp sgt i32 %.194, 0
  %.195 = load ptr, ptr %excinfo.1, align 8
  %.203 = select i1 %.202, ptr %.195, ptr undef
  store ptr %.203, ptr %excinfo, align 8
  br label %common.ret

B58.endif:
  %.137 = add nuw nsw i64 %.66.037, 1
  %exitcond.not = icmp eq i64 %.137, %.42
  br i1 %exitcond.not, label %B266, label %B56.if
}

define internal i32 @pull.41(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, i64 %arg.table, i64 %arg.which, i64 %arg.results, ptr noalias %arg.places, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.weights, ptr noalias %arg.Y_bar, ptr noalias %arg.numbers_bar, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.229 = alloca ptr, align 8
  store ptr null, ptr %.229, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.263 = alloca ptr, align 8
  store ptr null, ptr %.263, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.302 = alloca ptr, align 8
  store ptr null, ptr %.302, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %0 = getelementptr i64, ptr %arg.layout, i64 %arg.table
  %.45 = getelementptr i8, ptr %0, i64 8
  %.46 = load i64, ptr %.45, align 8
  %.47 = mul nsw i64 %.46, %arg.results
  %.51 = getelementptr i8, ptr %0, i64 24
  %.52 = load i64, ptr %.51, align 8
  %.53 = mul i64 %.52, %.46
  %.63 = getelementptr i8, ptr %0, i64 16
  %.64 = load i64, ptr %.63, align 8
  %.65 = mul nsw i64 %.64, %.46
  %.84 = load i64, ptr %0, align 8
  %.166102.not = icmp slt i64 %.84, 1
  br i1 %.166102.not, label %B690, label %B240.if.lr.ph

B240.if.lr.ph:
  %.72 = getelementptr i8, ptr %0, i64 80
  %.73 = load i64, ptr %.72, align 8
  %.207 = getelementptr i8, ptr %0, i64 48
  %.208 = load i64, ptr %.207, align 8
  %1 = getelementptr i32, ptr %arg.idx, i64 %.208
  %.217 = getelementptr i8, ptr %0, i64 56
  %.218 = load i64, ptr %.217, align 8
  %.260 = getelementptr double, ptr %arg.local, i64 %.65
  %.294.idx = shl i64 %.73, 4
  %.294 = getelementptr i8, ptr %arg.derived, i64 %.294.idx
  %.40699.not = icmp slt i64 %.53, 1
  %2 = getelementptr double, ptr %arg.out, i64 %.65
  br label %B240.if

B240.loopexit:
  %exitcond111.not = icmp eq i64 %.179, %.84
  br i1 %exitcond111.not, label %B690, label %B240.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B690 ], [ %.306, %B242.endif.endif.if ], [ %.267, %B242.endif.if ], [ %.233, %B242.if ]
  ret i32 %common.ret.op

B690:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B240.if:
  %.108.0103 = phi i64 [ 0, %B240.if.lr.ph ], [ %.179, %B240.loopexit ]
  %.179 = add nuw nsw i64 %.108.0103, 1
  %.210 = mul nsw i64 %.108.0103, %.65
  %.213 = getelementptr i32, ptr %1, i64 %.210
  %.220 = mul nsw i64 %.108.0103, %.53
  %.221 = add nsw i64 %.218, %.220
  store ptr null, ptr %.229, align 8
  %.233 = call i32 @gather.3(ptr nonnull %.229, ptr nonnull %excinfo.1, i64 %.65, ptr %.213, ptr %arg.Y, ptr %arg.local)
  switch i32 %.233, label %B242.if [
    i32 -2, label %B242.endif
    i32 0, label %B242.endif
  ]

B242.if:
  %.241 = icmp sgt i32 %.233, 0
  %.234 = load ptr, ptr %excinfo.1, align 8
  %.242 = select i1 %.241, ptr %.234, ptr undef
  store ptr %.242, ptr %excinfo, align 8
  br label %common.ret

B242.endif:
  %.255 = mul nsw i64 %.108.0103, %.47
  %.257 = getelementptr i32, ptr %arg.places, i64 %.255
  store ptr null, ptr %.263, align 8
  %.267 = call i32 @gather.3(ptr nonnull %.263, ptr nonnull %excinfo.2, i64 %.47, ptr %.257, ptr %arg.weights, ptr %.260)
  switch i32 %.267, label %B242.endif.if [
    i32 -2, label %B242.endif.endif
    i32 0, label %B242.endif.endif
  ]

B242.endif.if:
  %.275 = icmp sgt i32 %.267, 0
  %.268 = load ptr, ptr %excinfo.2, align 8
  %.276 = select i1 %.275, ptr %.268, ptr undef
  store ptr %.276, ptr %excinfo, align 8
  br label %common.ret

B242.endif.endif:
  %.289 = getelementptr double, ptr %arg.numbers, i64 %.221
  %.295 = load i64, ptr %.294, align 8
  %.296 = inttoptr i64 %.295 to ptr
  call void %.296(ptr %arg.local, ptr %.289, ptr %arg.out)
  store ptr null, ptr %.302, align 8
  %.306 = call i32 @scatter.2(ptr nonnull %.302, ptr nonnull %excinfo.3, i64 %.65, ptr %.213, ptr %arg.out, ptr %arg.Y_bar)
  switch i32 %.306, label %B242.endif.endif.if [
    i32 -2, label %B242.endif.endif.endif
    i32 0, label %B242.endif.endif.endif
  ]

B242.endif.endif.if:
  %.314 = icmp sgt i32 %.306, 0
  %.307 = load ptr, ptr %excinfo.3, align 8
  %.315 = select i1 %.314, ptr %.307, ptr undef
  store ptr %.315, ptr %excinfo, align 8
  br label %common.ret

B242.endif.endif.endif:
  br i1 %.40699.not, label %B240.loopexit, label %B626.if.lr.ph

B626.if.lr.ph:
  %3 = getelementptr double, ptr %arg.numbers_bar, i64 %.221
  br label %B626.if

B626.if:
  %.350.0100 = phi i64 [ 0, %B626.if.lr.ph ], [ %.419, %B626.if ]
  %.419 = add nuw nsw i64 %.350.0100, 1
  %.447 = getelementptr double, ptr %3, i64 %.350.0100
  %.448 = load double, ptr %.447, align 8
  %.452 = getelementptr double, ptr %2, i64 %.350.0100
  %.453 = load double, ptr %.452, align 8
  %.454 = fadd contract double %.448, %.453
  store double %.454, ptr %.447, align 8
  %exitcond.not = icmp eq i64 %.53, %.419
  br i1 %exitcond.not, label %B240.loopexit, label %B626.if
}

define i64 @rates_at(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9, ptr %a10, ptr %a11) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @rates_at.43(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9, ptr %a10, ptr %a11)
  ret i64 0
}

define internal i32 @rates_at.43(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.Y_dot, ptr noalias %arg.numbers_dot, ptr noalias %arg.r_dot, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.20 = alloca ptr, align 8
  store ptr null, ptr %.20, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.47 = alloca ptr, align 8
  store ptr null, ptr %.47, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.72 = alloca ptr, align 8
  store ptr null, ptr %.72, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.17 = load i64, ptr %arg.layout, align 8
  store ptr null, ptr %.20, align 8
  %.24 = call i32 @drive.6(ptr nonnull %.20, ptr nonnull %excinfo.1, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.local, ptr %arg.out)
  switch i32 %.24, label %B0.if [
    i32 -2, label %B0.endif
    i32 0, label %B0.endif
  ]

B0.if:
  %.32 = icmp sgt i32 %.24, 0
  %.25 = load ptr, ptr %excinfo.1, align 8
  %.33 = select i1 %.32, ptr %.25, ptr undef
  store ptr %.33, ptr %excinfo, align 8
  br label %common.ret

B0.endif:
  %.18 = getelementptr double, ptr %arg.Y_dot, i64 %.17
  store ptr null, ptr %.47, align 8
  %.51 = call i32 @push_drive.44(ptr nonnull %.47, ptr nonnull %excinfo.2, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, i64 0, ptr %arg.Y_dot, ptr %arg.numbers_dot, ptr %.18, ptr %arg.local, ptr %arg.out)
  switch i32 %.51, label %B0.endif.if [
    i32 -2, label %B0.endif.endif
    i32 0, label %B0.endif.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ %.51, %B0.endif.if ], [ %.24, %B0.if ], [ 0, %B0.endif.endif.endif ], [ %.76, %B0.endif.endif.if ]
  ret i32 %common.ret.op

B0.endif.if:
  %.59 = icmp sgt i32 %.51, 0
  %.52 = load ptr, ptr %excinfo.2, align 8
  %.60 = select i1 %.59, ptr %.52, ptr undef
  store ptr %.60, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif:
  store ptr null, ptr %.72, align 8
  %.76 = call i32 @push_residual.45(ptr nonnull %.72, ptr nonnull %excinfo.3, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.Y_dot, ptr %arg.numbers_dot, ptr %arg.r_dot, ptr %arg.local, ptr %arg.out)
  switch i32 %.76, label %B0.endif.endif.if [
    i32 -2, label %B0.endif.endif.endif
    i32 0, label %B0.endif.endif.endif
  ]

B0.endif.endif.if:
  %.84 = icmp sgt i32 %.76, 0
  %.77 = load ptr, ptr %excinfo.3, align 8
  %.85 = select i1 %.84, ptr %.77, ptr undef
  store ptr %.85, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif:
  store ptr null, ptr %retptr, align 8
  br label %common.ret
}

define internal i32 @push_drive.44(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, i64 %arg.which, ptr noalias %arg.Y_dot, ptr noalias %arg.numbers_dot, ptr noalias %arg.rates_dot, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.319 = alloca ptr, align 8
  store ptr null, ptr %.319, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.41 = getelementptr i8, ptr %arg.layout, i64 40
  %.42 = load i64, ptr %.41, align 8
  %.124126.not = icmp slt i64 %.42, 1
  br i1 %.124126.not, label %B496, label %B56.if.lr.ph

B56.if.lr.ph:
  %.163 = getelementptr i8, ptr %arg.layout, i64 32
  %.482 = getelementptr i8, ptr %arg.layout, i64 8
  br label %B56.if

B56.loopexit:
  %exitcond131.not = icmp eq i64 %.137, %.42
  br i1 %exitcond131.not, label %B496, label %B56.if

B248.loopexit:
  %exitcond130.not = icmp eq i64 %.282, %.189
  br i1 %exitcond130.not, label %B56.loopexit, label %B248.if

B456:
  %.489 = getelementptr double, ptr %arg.out, i64 %.380.0121
  %.490 = load double, ptr %.489, align 8
  %.499 = getelementptr double, ptr %arg.rates_dot, i64 %.484
  store double %.490, ptr %.499, align 8
  br label %B490

B490:
  %exitcond.not = icmp eq i64 %.181, %.449
  br i1 %exitcond.not, label %B248.loopexit, label %B406.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B496 ], [ %.323, %B250.if ]
  ret i32 %common.ret.op

B496:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B56.if:
  %.66.0127 = phi i64 [ 0, %B56.if.lr.ph ], [ %.137, %B56.loopexit ]
  %.137 = add nuw nsw i64 %.66.0127, 1
  %.164 = load i64, ptr %.163, align 8
  %.165 = add nsw i64 %.164, %.66.0127
  %.166 = mul nsw i64 %.165, 11
  %.167 = add nsw i64 %.166, 8
  %0 = getelementptr i64, ptr %arg.layout, i64 %.166
  %.174 = getelementptr i8, ptr %0, i64 96
  %.175 = load i64, ptr %.174, align 8
  %.179 = getelementptr i8, ptr %0, i64 72
  %.180 = load i64, ptr %.179, align 8
  %.181 = mul i64 %.180, %.175
  %.188 = getelementptr i64, ptr %arg.layout, i64 %.167
  %.189 = load i64, ptr %.188, align 8
  %.269123.not = icmp slt i64 %.189, 1
  br i1 %.269123.not, label %B56.loopexit, label %B248.if.lr.ph

B248.if.lr.ph:
  %.346 = getelementptr i8, ptr %0, i64 128
  %.436120.not = icmp slt i64 %.181, 1
  br label %B248.if

B248.if:
  %.213.0124 = phi i64 [ 0, %B248.if.lr.ph ], [ %.282, %B248.loopexit ]
  %.282 = add nuw nsw i64 %.213.0124, 1
  store ptr null, ptr %.319, align 8
  %.323 = call i32 @push.46(ptr nonnull %.319, ptr nonnull %excinfo.1, ptr %arg.layout, i64 %.167, i64 %arg.which, i64 %.213.0124, ptr %arg.derived, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.Y_dot, ptr %arg.numbers_dot, ptr %arg.local, ptr %arg.out)
  switch i32 %.323, label %B250.if [
    i32 -2, label %B250.endif
    i32 0, label %B250.endif
  ]

B250.if:
  %.331 = icmp sgt i32 %.323, 0
  %.324 = load ptr, ptr %excinfo.1, align 8
  %.332 = select i1 %.331, ptr %.324, ptr undef
  store ptr %.332, ptr %excinfo, align 8
  br label %common.ret

B250.endif:
  %.347 = load i64, ptr %.346, align 8
  %.349 = mul nsw i64 %.213.0124, %.181
  %1 = getelementptr i32, ptr %arg.rows, i64 %.347
  %.352 = getelementptr i32, ptr %1, i64 %.349
  br i1 %.436120.not, label %B248.loopexit, label %B406.if.lr.ph

B406.if.lr.ph:
  %.483 = load i64, ptr %.482, align 8
  br label %B406.if

B406.if:
  %.380.0121 = phi i64 [ 0, %B406.if.lr.ph ], [ %.449, %B490 ]
  %.449 = add nuw nsw i64 %.380.0121, 1
  %.479 = getelementptr i32, ptr %.352, i64 %.380.0121
  %.480 = load i32, ptr %.479, align 4
  %.484 = sext i32 %.480 to i64
  %.485 = icmp sgt i64 %.483, %.484
  br i1 %.485, label %B456, label %B490
}

define internal i32 @push_residual.45(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.Y_dot, ptr noalias %arg.numbers_dot, ptr noalias %arg.r_dot, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.657 = alloca ptr, align 8
  store ptr null, ptr %.657, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.689 = alloca ptr, align 8
  store ptr null, ptr %.689, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.39 = load i64, ptr %arg.layout, align 8
  %.122162 = icmp sgt i64 %.39, -1
  br i1 %.122162, label %B62.if.preheader, label %B78

B62.if.preheader:
  %storemerge = add nuw i64 %.39, 1
  %0 = add nuw i64 %.39, 2
  %smin = call i64 @llvm.smin.i64(i64 %storemerge, i64 1)
  %1 = sub i64 %0, %smin
  %2 = shl nuw i64 %1, 3
  call void @llvm.memset.p0.i64(ptr align 8 %arg.r_dot, i8 0, i64 %2, i1 false)
  br label %B78

B78:
  %.169 = getelementptr i8, ptr %arg.layout, i64 32
  %.170 = load i64, ptr %.169, align 8
  %.251171.not = icmp slt i64 %.170, 1
  br i1 %.251171.not, label %B880, label %B132.if

B282:
  %.314 = getelementptr i8, ptr %5, i64 56
  %.315 = load i64, ptr %.314, align 8
  %.319 = getelementptr i8, ptr %5, i64 48
  %.320 = load i64, ptr %.319, align 8
  %.322 = getelementptr i32, ptr %arg.idx, i64 %.320
  %.332 = getelementptr i8, ptr %5, i64 8
  %.333 = load i64, ptr %.332, align 8
  %.340 = load i64, ptr %5, align 8
  %.341 = mul nsw i64 %.340, %.333
  %.421168.not = icmp slt i64 %.341, 1
  br i1 %.421168.not, label %B881, label %B466.if

B624:
  %.513 = getelementptr i8, ptr %5, i64 32
  %.514 = load i64, ptr %.513, align 8
  %.518 = getelementptr i8, ptr %5, i64 8
  %.519 = load i64, ptr %.518, align 8
  %.520 = mul nsw i64 %.519, %.514
  %.528 = load i64, ptr %5, align 8
  %.608165.not = icmp slt i64 %.528, 1
  br i1 %.608165.not, label %B881, label %B748.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B880 ], [ %.693, %B750.endif.if ], [ %.661, %B750.if ]
  ret i32 %common.ret.op

B880:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B881:
  %exitcond179.not = icmp eq i64 %.170, %.264
  br i1 %exitcond179.not, label %B880, label %B132.if

B132.if:
  %.194.0172 = phi i64 [ %.264, %B881 ], [ 0, %B78 ]
  %.264 = add nuw nsw i64 %.194.0172, 1
  %3 = mul nuw nsw i64 %.194.0172, 11
  %4 = add nuw nsw i64 %3, 8
  %5 = getelementptr i64, ptr %arg.layout, i64 %4
  %.297 = getelementptr i8, ptr %5, i64 64
  %.298 = load i64, ptr %.297, align 8
  %.300 = getelementptr i32, ptr %arg.rows, i64 %.298
  %.307 = getelementptr i8, ptr %5, i64 80
  %.308 = load i64, ptr %.307, align 8
  %.309 = icmp eq i64 %.308, -1
  br i1 %.309, label %B282, label %B624

B466.if:
  %.365.0169 = phi i64 [ %.434, %B466.if ], [ 0, %B282 ]
  %.434 = add nuw nsw i64 %.365.0169, 1
  %.460 = add nsw i64 %.365.0169, %.315
  %.462 = getelementptr double, ptr %arg.numbers, i64 %.460
  %.463 = load double, ptr %.462, align 8
  %.465 = getelementptr i32, ptr %.322, i64 %.365.0169
  %.466 = load i32, ptr %.465, align 4
  %.468 = sext i32 %.466 to i64
  %.469 = getelementptr double, ptr %arg.Y_dot, i64 %.468
  %.470 = load double, ptr %.469, align 8
  %.471 = fmul contract double %.463, %.470
  %.473 = getelementptr i32, ptr %.300, i64 %.365.0169
  %.474 = load i32, ptr %.473, align 4
  %.476 = sext i32 %.474 to i64
  %.477 = getelementptr double, ptr %arg.r_dot, i64 %.476
  %.478 = load double, ptr %.477, align 8
  %.482 = getelementptr double, ptr %arg.numbers_dot, i64 %.460
  %.483 = load double, ptr %.482, align 8
  %.489 = getelementptr double, ptr %arg.Y, i64 %.468
  %.490 = load double, ptr %.489, align 8
  %.491 = fmul contract double %.483, %.490
  %.492 = fadd contract double %.471, %.491
  %.493 = fadd contract double %.478, %.492
  store double %.493, ptr %.477, align 8
  %exitcond178.not = icmp eq i64 %.341, %.434
  br i1 %exitcond178.not, label %B881, label %B466.if

B748.if:
  %.552.0166 = phi i64 [ %.621, %B750.endif.endif ], [ 0, %B624 ]
  %.621 = add nuw nsw i64 %.552.0166, 1
  store ptr null, ptr %.657, align 8
  %.661 = call i32 @push.46(ptr nonnull %.657, ptr nonnull %excinfo.1, ptr nonnull %arg.layout, i64 %4, i64 0, i64 %.552.0166, ptr %arg.derived, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.Y_dot, ptr %arg.numbers_dot, ptr %arg.local, ptr %arg.out)
  switch i32 %.661, label %B750.if [
    i32 -2, label %B750.endif
    i32 0, label %B750.endif
  ]

B750.if:
  %.669 = icmp sgt i32 %.661, 0
  %.662 = load ptr, ptr %excinfo.1, align 8
  %.670 = select i1 %.669, ptr %.662, ptr undef
  store ptr %.670, ptr %excinfo, align 8
  br label %common.ret

B750.endif:
  %.683 = mul nsw i64 %.552.0166, %.520
  %.685 = getelementptr i32, ptr %.300, i64 %.683
  store ptr null, ptr %.689, align 8
  %.693 = call i32 @scatter.2(ptr nonnull %.689, ptr nonnull %excinfo.2, i64 %.520, ptr %.685, ptr %arg.out, ptr %arg.r_dot)
  switch i32 %.693, label %B750.endif.if [
    i32 -2, label %B750.endif.endif
    i32 0, label %B750.endif.endif
  ]

B750.endif.if:
  %.701 = icmp sgt i32 %.693, 0
  %.694 = load ptr, ptr %excinfo.2, align 8
  %.702 = select i1 %.701, ptr %.694, ptr undef
  store ptr %.702, ptr %excinfo, align 8
  br label %common.ret

B750.endif.endif:
  %exitcond.not = icmp eq i64 %.528, %.621
  br i1 %exitcond.not, label %B881, label %B748.if
}

define internal i32 @push.46(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, i64 %arg.table, i64 %arg.which, i64 %arg.group, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.Y_dot, ptr noalias %arg.numbers_dot, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.69 = alloca ptr, align 8
  store ptr null, ptr %.69, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.98 = alloca ptr, align 8
  store ptr null, ptr %.98, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %0 = getelementptr i64, ptr %arg.layout, i64 %arg.table
  %.35 = getelementptr i8, ptr %0, i64 8
  %.36 = load i64, ptr %.35, align 8
  %.40 = getelementptr i8, ptr %0, i64 16
  %.41 = load i64, ptr %.40, align 8
  %.42 = mul i64 %.41, %.36
  %.46 = getelementptr i8, ptr %0, i64 24
  %.47 = load i64, ptr %.46, align 8
  %.48 = mul nsw i64 %.47, %.36
  %.52 = getelementptr i8, ptr %0, i64 48
  %.53 = load i64, ptr %.52, align 8
  %.54 = mul nsw i64 %.42, %arg.group
  %1 = getelementptr i32, ptr %arg.idx, i64 %.53
  %.56 = getelementptr i32, ptr %1, i64 %.54
  %.60 = getelementptr i8, ptr %0, i64 56
  %.61 = load i64, ptr %.60, align 8
  %.62 = mul nsw i64 %.48, %arg.group
  %.63 = add nsw i64 %.61, %.62
  store ptr null, ptr %.69, align 8
  %.73 = call i32 @gather.3(ptr nonnull %.69, ptr nonnull %excinfo.1, i64 %.42, ptr %.56, ptr %arg.Y, ptr %arg.local)
  switch i32 %.73, label %B0.if [
    i32 -2, label %B0.endif
    i32 0, label %B0.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ 0, %B430 ], [ %.102, %B0.endif.if ], [ %.73, %B0.if ]
  ret i32 %common.ret.op

B430:
  %.267 = getelementptr i8, ptr %0, i64 80
  %.268 = load i64, ptr %.267, align 8
  %.279 = getelementptr double, ptr %arg.numbers, i64 %.63
  %.idx = shl i64 %.268, 4
  %2 = getelementptr i8, ptr %arg.derived, i64 %.idx
  %.287 = getelementptr i8, ptr %2, i64 16
  %.288 = load i64, ptr %.287, align 8
  %.289 = inttoptr i64 %.288 to ptr
  call void %.289(ptr %arg.local, ptr %.279, ptr %arg.out)
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B0.if:
  %.81 = icmp sgt i32 %.73, 0
  %.74 = load ptr, ptr %excinfo.1, align 8
  %.82 = select i1 %.81, ptr %.74, ptr undef
  store ptr %.82, ptr %excinfo, align 8
  br label %common.ret

B0.endif:
  %.97 = getelementptr double, ptr %arg.local, i64 %.42
  store ptr null, ptr %.98, align 8
  %.102 = call i32 @gather.3(ptr nonnull %.98, ptr nonnull %excinfo.2, i64 %.42, ptr %.56, ptr %arg.Y_dot, ptr %.97)
  switch i32 %.102, label %B0.endif.if [
    i32 -2, label %B0.endif.endif
    i32 0, label %B0.endif.endif
  ]

B0.endif.if:
  %.110 = icmp sgt i32 %.102, 0
  %.103 = load ptr, ptr %excinfo.2, align 8
  %.111 = select i1 %.110, ptr %.103, ptr undef
  store ptr %.111, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif:
  %.20746.not = icmp slt i64 %.48, 1
  br i1 %.20746.not, label %B430, label %B396.if.lr.ph

B396.if.lr.ph:
  %.124.idx = shl i64 %.42, 4
  %.124 = getelementptr i8, ptr %arg.local, i64 %.124.idx
  %3 = getelementptr double, ptr %arg.numbers_dot, i64 %.63
  %4 = mul i64 %.47, %.36
  %5 = shl i64 %4, 3
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %.124, ptr align 8 %3, i64 %5, i1 false)
  br label %B430
}

define i64 @reverse(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, i64 %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, ptr %a14, i64 %a15, ptr %a16, ptr %a17, ptr %a18, ptr %a19, ptr %a20, ptr %a21, i64 %a22, ptr %a23, i64 %a24, ptr %a25, ptr %a26, ptr %a27, ptr %a28, ptr %a29, ptr %a30, ptr %a31) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @reverse.47(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, i64 %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, ptr %a14, i64 %a15, ptr %a16, ptr %a17, ptr %a18, ptr %a19, ptr %a20, ptr %a21, i64 %a22, ptr %a23, i64 %a24, ptr %a25, ptr %a26, ptr %a27, ptr %a28, ptr %a29, ptr %a30, ptr %a31)
  ret i64 0
}

define internal i32 @reverse.47(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.pos, ptr noalias %arg.numbers, ptr noalias %arg.drive_rows, ptr noalias %arg.drive_columns, i64 %arg.blocks, ptr noalias %arg.own, ptr noalias %arg.slots, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, i64 %arg.entry_count, ptr noalias %arg.entry_rows, ptr noalias %arg.entry_columns, ptr noalias %arg.entry_places, ptr noalias %arg.mass, ptr noalias %arg.method, ptr noalias %arg.record, i64 %arg.step_count, ptr noalias %arg.edges, i64 %arg.edge_count, ptr noalias %arg.weights, ptr noalias %arg.Y, ptr noalias %arg.y_bar, ptr noalias %arg.Y_bar, ptr noalias %arg.numbers_bar, ptr noalias %arg.ends_bar, ptr noalias %arg.work) noinline {
entry:
  %.437 = alloca ptr, align 8
  store ptr null, ptr %.437, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.754 = alloca i64, align 8
  store i64 0, ptr %.754, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.911 = alloca double, align 8
  store double 0.000000e+00, ptr %.911, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.948 = alloca ptr, align 8
  store ptr null, ptr %.948, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.977 = alloca ptr, align 8
  store ptr null, ptr %.977, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.1121 = alloca double, align 8
  store double 0.000000e+00, ptr %.1121, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.1152 = alloca ptr, align 8
  store ptr null, ptr %.1152, align 8
  %excinfo.7 = alloca ptr, align 8
  store ptr null, ptr %excinfo.7, align 8
  %.1189 = alloca ptr, align 8
  store ptr null, ptr %.1189, align 8
  %excinfo.8 = alloca ptr, align 8
  store ptr null, ptr %excinfo.8, align 8
  %.1217 = alloca double, align 8
  store double 0.000000e+00, ptr %.1217, align 8
  %excinfo.9 = alloca ptr, align 8
  store ptr null, ptr %excinfo.9, align 8
  %.1300 = alloca ptr, align 8
  store ptr null, ptr %.1300, align 8
  %excinfo.10 = alloca ptr, align 8
  store ptr null, ptr %excinfo.10, align 8
  %.1482 = alloca ptr, align 8
  store ptr null, ptr %.1482, align 8
  %excinfo.11 = alloca ptr, align 8
  store ptr null, ptr %excinfo.11, align 8
  %.1514 = alloca ptr, align 8
  store ptr null, ptr %.1514, align 8
  %excinfo.12 = alloca ptr, align 8
  store ptr null, ptr %excinfo.12, align 8
  %.1560 = alloca ptr, align 8
  store ptr null, ptr %.1560, align 8
  %excinfo.13 = alloca ptr, align 8
  store ptr null, ptr %excinfo.13, align 8
  %.1715 = alloca ptr, align 8
  store ptr null, ptr %.1715, align 8
  %excinfo.14 = alloca ptr, align 8
  store ptr null, ptr %excinfo.14, align 8
  %.1755 = alloca ptr, align 8
  store ptr null, ptr %.1755, align 8
  %excinfo.15 = alloca ptr, align 8
  store ptr null, ptr %excinfo.15, align 8
  %.1791 = alloca ptr, align 8
  store ptr null, ptr %.1791, align 8
  %excinfo.16 = alloca ptr, align 8
  store ptr null, ptr %excinfo.16, align 8
  %.1823 = alloca ptr, align 8
  store ptr null, ptr %.1823, align 8
  %excinfo.17 = alloca ptr, align 8
  store ptr null, ptr %excinfo.17, align 8
  %.1852 = alloca ptr, align 8
  store ptr null, ptr %.1852, align 8
  %excinfo.18 = alloca ptr, align 8
  store ptr null, ptr %excinfo.18, align 8
  %.2179 = alloca ptr, align 8
  store ptr null, ptr %.2179, align 8
  %excinfo.19 = alloca ptr, align 8
  store ptr null, ptr %excinfo.19, align 8
  %.2213 = alloca ptr, align 8
  store ptr null, ptr %.2213, align 8
  %excinfo.20 = alloca ptr, align 8
  store ptr null, ptr %excinfo.20, align 8
  %.2251 = alloca double, align 8
  store double 0.000000e+00, ptr %.2251, align 8
  %excinfo.21 = alloca ptr, align 8
  store ptr null, ptr %excinfo.21, align 8
  %.2303 = alloca double, align 8
  store double 0.000000e+00, ptr %.2303, align 8
  %excinfo.22 = alloca ptr, align 8
  store ptr null, ptr %excinfo.22, align 8
  %.2342 = alloca double, align 8
  store double 0.000000e+00, ptr %.2342, align 8
  %excinfo.23 = alloca ptr, align 8
  store ptr null, ptr %excinfo.23, align 8
  %.2383 = alloca ptr, align 8
  store ptr null, ptr %.2383, align 8
  %excinfo.24 = alloca ptr, align 8
  store ptr null, ptr %excinfo.24, align 8
  %.3138 = alloca ptr, align 8
  store ptr null, ptr %.3138, align 8
  %excinfo.25 = alloca ptr, align 8
  store ptr null, ptr %excinfo.25, align 8
  %.3180 = alloca ptr, align 8
  store ptr null, ptr %.3180, align 8
  %excinfo.26 = alloca ptr, align 8
  store ptr null, ptr %excinfo.26, align 8
  %.3343 = alloca ptr, align 8
  store ptr null, ptr %.3343, align 8
  %excinfo.27 = alloca ptr, align 8
  store ptr null, ptr %excinfo.27, align 8
  %.3379 = alloca ptr, align 8
  store ptr null, ptr %.3379, align 8
  %excinfo.28 = alloca ptr, align 8
  store ptr null, ptr %excinfo.28, align 8
  %.3415 = alloca ptr, align 8
  store ptr null, ptr %.3415, align 8
  %excinfo.29 = alloca ptr, align 8
  store ptr null, ptr %excinfo.29, align 8
  %.3454 = alloca ptr, align 8
  store ptr null, ptr %.3454, align 8
  %excinfo.30 = alloca ptr, align 8
  store ptr null, ptr %excinfo.30, align 8
  %.3482 = alloca ptr, align 8
  store ptr null, ptr %.3482, align 8
  %excinfo.31 = alloca ptr, align 8
  store ptr null, ptr %excinfo.31, align 8
  %.98 = load i64, ptr %arg.layout, align 8
  %.100 = getelementptr i8, ptr %arg.layout, i64 16
  %.101 = load i64, ptr %.100, align 8
  %.109 = getelementptr i8, ptr %arg.layout, i64 8
  %.110 = load i64, ptr %.109, align 8
  %.114 = getelementptr i8, ptr %arg.layout, i64 24
  %.115 = load i64, ptr %.114, align 8
  %.123 = add i64 %.101, 1
  %.125 = add i64 %.115, %.123
  %.131 = shl nsw i64 %.98, 3
  %.132 = getelementptr double, ptr %arg.work, i64 %.131
  %.141.idx = mul i64 %.98, 136
  %.141 = getelementptr i8, ptr %arg.work, i64 %.141.idx
  %.144.idx = mul i64 %.98, 200
  %.144 = getelementptr i8, ptr %arg.work, i64 %.144.idx
  %.153.idx = mul i64 %.98, 264
  %.153 = getelementptr i8, ptr %arg.work, i64 %.153.idx
  %.idx = mul i64 %.98, 272
  %0 = getelementptr i8, ptr %arg.work, i64 %.idx
  %.157 = getelementptr i8, ptr %0, i64 8
  %.idx650 = mul i64 %.98, 280
  %1 = getelementptr i8, ptr %arg.work, i64 %.idx650
  %.161 = getelementptr i8, ptr %1, i64 8
  %.idx651 = mul i64 %.98, 288
  %2 = getelementptr i8, ptr %arg.work, i64 %.idx651
  %.174 = getelementptr i8, ptr %2, i64 8
  %.idx652 = mul i64 %.98, 296
  %3 = getelementptr i8, ptr %arg.work, i64 %.idx652
  %.178 = getelementptr i8, ptr %3, i64 8
  %.idx653 = mul i64 %.98, 304
  %4 = getelementptr i8, ptr %arg.work, i64 %.idx653
  %.188 = getelementptr i8, ptr %4, i64 8
  %.195.idx = shl i64 %arg.blocks, 5
  %.195 = getelementptr i8, ptr %.188, i64 %.195.idx
  %.202.idx = shl i64 %arg.blocks, 4
  %.202 = getelementptr i8, ptr %.195, i64 %.202.idx
  %.208 = getelementptr double, ptr %.202, i64 %.101
  %.214 = getelementptr double, ptr %.208, i64 %.125
  %.220 = getelementptr double, ptr %.214, i64 %.125
  %.227 = add nsw i64 %.110, 1
  %.229 = getelementptr double, ptr %.220, i64 %.227
  %.238 = getelementptr double, ptr %.229, i64 %.227
  %.243 = getelementptr i8, ptr %arg.layout, i64 56
  %.244 = load i64, ptr %.243, align 8
  %.246 = getelementptr double, ptr %.238, i64 %.244
  %.336953 = icmp sgt i64 %arg.step_count, 0
  br i1 %.336953, label %B918.lr.ph, label %B4338

B918.lr.ph:
  %.280.1956 = add nsw i64 %arg.step_count, -1
  %.112 = add i64 %.110, %.98
  %.378 = add nsw i64 %arg.step_count, -1
  %.382 = add nsw i64 %.98, 3
  %.464 = getelementptr double, ptr %.132, i64 %.131
  %.517 = icmp sgt i64 %.98, 0
  %storemerge654 = select i1 %.517, i64 %.131, i64 0
  %.559904 = icmp sgt i64 %storemerge654, 0
  %.1297.idx = mul i64 %.98, 56
  %.1297 = getelementptr i8, ptr %.141, i64 %.1297.idx
  %.1325 = getelementptr i8, ptr %arg.method, i64 1344
  %.1549 = getelementptr double, ptr %arg.Y, i64 %.112
  %5 = call i64 @llvm.smax.i64(i64 %.112, i64 -1)
  %storemerge662 = add i64 %5, 1
  %.1665918 = icmp sgt i64 %.112, -1
  %.1741 = getelementptr double, ptr %.153, i64 %.98
  %.1883 = getelementptr double, ptr %arg.Y_bar, i64 %.112
  %.1984921.not = icmp slt i64 %.98, 1
  %storemerge657 = call i64 @llvm.smax.i64(i64 %.125, i64 0)
  %.2498933.not = icmp slt i64 %.125, 1
  %.2624941.not = icmp slt i64 %arg.entry_count, 1
  %.3044947.not = icmp slt i64 %.115, 1
  %.3167 = getelementptr double, ptr %arg.Y, i64 %.112
  %.3285950 = icmp sgt i64 %.112, -1
  %.3441 = getelementptr double, ptr %arg.Y_bar, i64 %.112
  %.3510 = getelementptr i8, ptr %arg.ends_bar, i64 8
  %6 = shl nuw i64 %storemerge654, 3
  %7 = add i64 %5, 2
  %smin = call i64 @llvm.smin.i64(i64 %storemerge662, i64 1)
  %8 = sub i64 %7, %smin
  %9 = shl nuw i64 %8, 3
  %10 = mul i64 %arg.blocks, 48
  %11 = shl i64 %.101, 4
  %12 = shl i64 %.115, 3
  %13 = getelementptr i8, ptr %arg.work, i64 %.idx653
  %14 = getelementptr i8, ptr %13, i64 %10
  %15 = getelementptr i8, ptr %14, i64 %11
  %16 = getelementptr i8, ptr %15, i64 %12
  %scevgep = getelementptr i8, ptr %16, i64 16
  %17 = shl nuw i64 %storemerge657, 3
  %18 = mul i64 %arg.blocks, 48
  %19 = mul i64 %.101, 24
  %20 = shl i64 %.115, 4
  %21 = shl i64 %.110, 3
  %22 = getelementptr i8, ptr %arg.work, i64 %.idx653
  %23 = getelementptr i8, ptr %22, i64 %18
  %24 = getelementptr i8, ptr %23, i64 %19
  %25 = getelementptr i8, ptr %24, i64 %20
  %26 = getelementptr i8, ptr %25, i64 %21
  %scevgep1196 = getelementptr i8, ptr %26, i64 32
  %27 = add i64 %5, 2
  %smin1199 = call i64 @llvm.smin.i64(i64 %storemerge662, i64 1)
  %28 = sub i64 %27, %smin1199
  %29 = shl nuw i64 %28, 3
  br label %B918

B918:
  %.326.sroa.0.0960 = phi i64 [ 0, %B918.lr.ph ], [ %.326.sroa.0.0, %B4334 ]
  %.280.1959 = phi i64 [ %.280.1956, %B918.lr.ph ], [ %.280.1, %B4334 ]
  %.277.1958 = phi i64 [ 1, %B918.lr.ph ], [ %.277.1, %B4334 ]
  %stop.2.0957 = phi i64 [ %arg.edge_count, %B918.lr.ph ], [ %.768, %B4334 ]
  %.380 = sub nsw i64 %.378, %.326.sroa.0.0960
  %.383 = mul nsw i64 %.380, %.382
  %.385 = getelementptr double, ptr %arg.record, i64 %.383
  %.391 = load double, ptr %.385, align 8
  %.393 = getelementptr i8, ptr %.385, i64 8
  %.394 = load double, ptr %.393, align 8
  %.396 = getelementptr i8, ptr %.385, i64 24
  store ptr null, ptr %.437, align 8
  %.441 = call i32 @replay.48(ptr nonnull %.437, ptr nonnull %excinfo.1, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.pos, ptr %arg.numbers, ptr %arg.drive_rows, ptr %arg.drive_columns, i64 %arg.blocks, ptr %arg.own, ptr %arg.slots, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %arg.mass, ptr %arg.method, ptr nonnull %.385, ptr %arg.Y, ptr %arg.work, ptr %.132, ptr %.208, ptr %.220, ptr %.161, ptr %.202, ptr %.153, ptr %.157, ptr %.188, ptr %.195, ptr %.238, ptr %.246)
  switch i32 %.441, label %B918.if [
    i32 -2, label %B918.endif
    i32 0, label %B918.endif
  ]

B1268:
  br i1 %.517, label %B1298.if, label %B1326

B1326:
  store i64 0, ptr %.754, align 8
  %.758 = call i32 @first_edge_in.49(ptr nonnull %.754, ptr nonnull %excinfo.2, ptr %arg.edges, i64 %stop.2.0957, double %.391)
  %.768 = load i64, ptr %.754, align 8
  switch i32 %.758, label %B1326.if [
    i32 -2, label %B1326.endif
    i32 0, label %B1326.endif
  ]

B1706:
  store ptr null, ptr %.1189, align 8
  %.1193 = call i32 @dense_rate.50(ptr nonnull %.1189, ptr nonnull %excinfo.8, i64 %.98, ptr %arg.method, double %.925, ptr %.396, ptr %.464, ptr %arg.work, ptr %.153)
  switch i32 %.1193, label %B1706.if [
    i32 -2, label %B1706.endif
    i32 0, label %B1706.endif
  ]

B1822:
  %h_bar.6.1.lcssa = phi double [ 0.000000e+00, %B1326.endif ], [ %.1253, %B1706.endif.endif ]
  %time_bar.4.1.lcssa = phi double [ 0.000000e+00, %B1326.endif ], [ %.1262, %B1706.endif.endif ]
  store ptr null, ptr %.1300, align 8
  %.1304 = call i32 @add_scaled.29(ptr nonnull %.1300, ptr nonnull %excinfo.10, i64 %.98, double 1.000000e+00, ptr %arg.y_bar, ptr %.1297)
  switch i32 %.1304, label %B1822.if [
    i32 -2, label %B1822.endif
    i32 0, label %B1822.endif
  ]

B2356:
  store ptr null, ptr %.1715, align 8
  %.1719 = call i32 @copy.27(ptr nonnull %.1715, ptr nonnull %excinfo.14, i64 %.98, ptr %.1463, ptr %.153)
  switch i32 %.1719, label %B2356.if [
    i32 -2, label %B2356.endif
    i32 0, label %B2356.endif
  ]

B2528:
  store ptr null, ptr %.1823, align 8
  %.1827 = call i32 @add_scaled.29(ptr nonnull %.1823, ptr nonnull %excinfo.17, i64 %.98, double 1.000000e+00, ptr %arg.y_bar, ptr %arg.Y_bar)
  switch i32 %.1827, label %B2528.if [
    i32 -2, label %B2564
    i32 0, label %B2564
  ]

B2564:
  store ptr null, ptr %.1852, align 8
  %.1856 = call i32 @add_scaled.29(ptr nonnull %.1852, ptr nonnull %excinfo.18, i64 %.98, double 1.000000e+00, ptr %arg.Y_bar, ptr %.178)
  switch i32 %.1856, label %B2564.if [
    i32 -2, label %B2564.endif
    i32 0, label %B2564.endif
  ]

B2760:
  %.2086 = icmp samesign ugt i64 %.1359.0929, 6
  br i1 %.2086, label %B3096, label %B2790.if.lr.ph

B2790.if.lr.ph:
  %.idx665 = shl nuw nsw i64 %35, 6
  %30 = getelementptr i8, ptr %arg.method, i64 %.idx665
  %31 = getelementptr i8, ptr %30, i64 512
  br label %B2790.if

B3096:
  %h_bar.8.2.lcssa = phi double [ %.1887, %B2760 ], [ %.2282, %B2792.endif.endif.endif ]
  %.2300 = getelementptr double, ptr %arg.work, i64 %.1461
  store double 0.000000e+00, ptr %.2303, align 8
  %.2307 = call i32 @dot.51(ptr nonnull %.2303, ptr nonnull %excinfo.22, i64 %.98, ptr %.157, ptr %.2300)
  switch i32 %.2307, label %B3096.if [
    i32 -2, label %B3096.endif
    i32 0, label %B3096.endif
  ]

B3324:
  br i1 %.2498933.not, label %B3370, label %B3354.if.preheader

B3354.if.preheader:
  call void @llvm.memset.p0.i64(ptr align 8 %scevgep, i8 0, i64 %17, i1 false)
  br label %B3370

B3370:
  br i1 %.2624941.not, label %B3566, label %B3400.if

B3542:
  %.2637 = add nuw nsw i64 %.2568.0942, 1
  %.2819 = getelementptr i32, ptr %arg.entry_places, i64 %.2568.0942
  %.2820 = load i32, ptr %.2819, align 4
  %.2825 = sext i32 %.2820 to i64
  %.2826 = getelementptr double, ptr %.214, i64 %.2825
  store double %.2809, ptr %.2826, align 8
  %exitcond1195.not = icmp eq i64 %arg.entry_count, %.2637
  br i1 %exitcond1195.not, label %B3566, label %B3400.if

B3566:
  %.2837 = load i64, ptr %.109, align 8
  %.2918944 = icmp sgt i64 %.2837, -1
  br i1 %.2918944, label %B3624.if.preheader, label %B3640

B3624.if.preheader:
  %storemerge659 = add nuw i64 %.2837, 1
  %32 = add nuw i64 %.2837, 2
  %smin1197 = call i64 @llvm.smin.i64(i64 %storemerge659, i64 1)
  %33 = sub i64 %32, %smin1197
  %34 = shl nuw i64 %33, 3
  call void @llvm.memset.p0.i64(ptr align 8 %scevgep1196, i8 0, i64 %34, i1 false)
  br label %B3640

B3640:
  br i1 %.3044947.not, label %B3850, label %B3670.if

B3850:
  store ptr null, ptr %.3138, align 8
  %.3142 = call i32 @copy.27(ptr nonnull %.3138, ptr nonnull %excinfo.25, i64 %.98, ptr %.396, ptr %arg.Y)
  switch i32 %.3142, label %B3850.if [
    i32 -2, label %B3850.endif
    i32 0, label %B3850.endif
  ]

B3990:
  store ptr null, ptr %.3343, align 8
  %.3347 = call i32 @pull_drive.52(ptr nonnull %.3343, ptr nonnull %excinfo.27, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, i64 1, ptr %.229, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %.238, ptr %.246)
  switch i32 %.3347, label %B3990.if [
    i32 -2, label %B3990.endif
    i32 0, label %B3990.endif
  ]

B4246:
  %.3511 = load double, ptr %.3510, align 8
  %.3513 = fadd contract double %.2367, %.3511
  store double %.3513, ptr %.3510, align 8
  br label %B4278

B4278:
  %.3521 = icmp eq i64 %.326.sroa.0.0960, %.378
  br i1 %.3521, label %B4296, label %B4334

B4296:
  %.3527 = load double, ptr %arg.ends_bar, align 8
  %.3530 = fsub contract double %.3444, %.2367
  %.3535 = fadd contract double %.3530, %.3527
  store double %.3535, ptr %arg.ends_bar, align 8
  br label %B4334

B4334:
  %.336 = icmp sgt i64 %.280.1959, 0
  %.349 = zext i1 %.336 to i64
  %.277.1 = add i64 %.277.1958, %.349
  %.345 = sext i1 %.336 to i64
  %.280.1 = add nsw i64 %.280.1959, %.345
  %.326.sroa.0.0 = select i1 %.336, i64 %.277.1958, i64 0
  br i1 %.336, label %B918, label %B4338

common.ret:
  %common.ret.op = phi i32 [ 0, %B4338 ], [ %.3486, %B3990.endif.endif.endif.endif.if ], [ %.3458, %B3990.endif.endif.endif.if ], [ %.3419, %B3990.endif.endif.if ], [ %.3383, %B3990.endif.if ], [ %.441, %B918.if ], [ %.3347, %B3990.if ], [ %.758, %B1326.if ], [ %.915, %B1394.if ], [ %.952, %B1394.endif.if ], [ %.3184, %B3850.endif.if ], [ %.981, %B1394.endif.endif.if ], [ %.1125, %B1598.if ], [ %.1156, %B1598.endif.if ], [ %.1193, %B1706.if ], [ %.1221, %B1706.endif.if ], [ %.2307, %B3096.if ], [ %.1304, %B1822.if ], [ %.1486, %B1994.if ], [ %.1518, %B1994.endif.if ], [ %.3142, %B3850.if ], [ %.1564, %B1994.endif.endif.if ], [ %.1719, %B2356.if ], [ %.1759, %B2356.endif.if ], [ %.1795, %B2356.endif.endif.if ], [ %.1827, %B2528.if ], [ %.2387, %B3096.endif.endif.if ], [ %.2346, %B3096.endif.if ], [ %.1856, %B2564.if ], [ %.2183, %B2792.if ], [ %.2217, %B2792.endif.if ], [ %.2255, %B2792.endif.endif.if ]
  ret i32 %common.ret.op

B4338:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B918.if:
  %.449 = icmp sgt i32 %.441, 0
  %.442 = load ptr, ptr %excinfo.1, align 8
  %.450 = select i1 %.449, ptr %.442, ptr undef
  store ptr %.450, ptr %excinfo, align 8
  br label %common.ret

B918.endif:
  br i1 %.559904, label %B1252.if.preheader, label %B1268

B1252.if.preheader:
  call void @llvm.memset.p0.i64(ptr align 8 %.141, i8 0, i64 %6, i1 false)
  br label %B1268

B1298.if:
  %.629.0908 = phi i64 [ %.698, %B1298.if ], [ 0, %B1268 ]
  %.698 = add nuw nsw i64 %.629.0908, 1
  %.728 = getelementptr double, ptr %.178, i64 %.629.0908
  store double 0.000000e+00, ptr %.728, align 8
  %.731 = getelementptr double, ptr %.174, i64 %.629.0908
  store double 0.000000e+00, ptr %.731, align 8
  %exitcond.not = icmp eq i64 %.98, %.698
  br i1 %exitcond.not, label %B1326, label %B1298.if

B1326.if:
  %.766 = icmp sgt i32 %.758, 0
  %.759 = load ptr, ptr %excinfo.2, align 8
  %.767 = select i1 %.766, ptr %.759, ptr undef
  store ptr %.767, ptr %excinfo, align 8
  br label %common.ret

B1326.endif:
  %.821 = sub i64 %stop.2.0957, %.768
  %.864912.not = icmp slt i64 %.821, 1
  br i1 %.864912.not, label %B1822, label %B1392.if

B1392.if:
  %time_bar.4.1916 = phi double [ %.1262, %B1706.endif.endif ], [ 0.000000e+00, %B1326.endif ]
  %h_bar.6.1915 = phi double [ %.1253, %B1706.endif.endif ], [ 0.000000e+00, %B1326.endif ]
  %.811.0914 = phi i64 [ %.873, %B1706.endif.endif ], [ %.821, %B1326.endif ]
  %.808.0913 = phi i64 [ %.877, %B1706.endif.endif ], [ %.768, %B1326.endif ]
  %.873 = add nsw i64 %.811.0914, -1
  %.877 = add i64 %.808.0913, 1
  %.903 = mul nsw i64 %.808.0913, %.98
  %.905 = getelementptr double, ptr %arg.weights, i64 %.903
  %.908 = getelementptr double, ptr %arg.edges, i64 %.808.0913
  %.909 = load double, ptr %.908, align 8
  store double 0.000000e+00, ptr %.911, align 8
  %.915 = call i32 @part_done.53(ptr nonnull %.911, ptr nonnull %excinfo.3, double %.909, ptr nonnull %.385)
  %.925 = load double, ptr %.911, align 8
  switch i32 %.915, label %B1394.if [
    i32 -2, label %B1394.endif
    i32 0, label %B1394.endif
  ]

B1394.if:
  %.923 = icmp sgt i32 %.915, 0
  %.916 = load ptr, ptr %excinfo.3, align 8
  %.924 = select i1 %.923, ptr %.916, ptr undef
  store ptr %.924, ptr %excinfo, align 8
  br label %common.ret

B1394.endif:
  %.944 = fsub contract double 1.000000e+00, %.925
  store ptr null, ptr %.948, align 8
  %.952 = call i32 @add_scaled.29(ptr nonnull %.948, ptr nonnull %excinfo.4, i64 %.98, double %.944, ptr %.905, ptr %.178)
  switch i32 %.952, label %B1394.endif.if [
    i32 -2, label %B1394.endif.endif
    i32 0, label %B1394.endif.endif
  ]

B1394.endif.if:
  %.960 = icmp sgt i32 %.952, 0
  %.953 = load ptr, ptr %excinfo.4, align 8
  %.961 = select i1 %.960, ptr %.953, ptr undef
  store ptr %.961, ptr %excinfo, align 8
  br label %common.ret

B1394.endif.endif:
  store ptr null, ptr %.977, align 8
  %.981 = call i32 @add_scaled.29(ptr nonnull %.977, ptr nonnull %excinfo.5, i64 %.98, double %.925, ptr %.905, ptr %arg.y_bar)
  switch i32 %.981, label %B1394.endif.endif.if [
    i32 -2, label %B1596.if.preheader
    i32 0, label %B1596.if.preheader
  ]

B1596.if.preheader:
  br label %B1596.if

B1394.endif.endif.if:
  %.989 = icmp sgt i32 %.981, 0
  %.982 = load ptr, ptr %excinfo.5, align 8
  %.990 = select i1 %.989, ptr %.982, ptr undef
  store ptr %.990, ptr %excinfo, align 8
  br label %common.ret

B1596.if:
  %.1024.0910 = phi i64 [ %.1093, %B1598.endif.endif ], [ 0, %B1596.if.preheader ]
  %.1093 = add nuw nsw i64 %.1024.0910, 1
  store double 0.000000e+00, ptr %.1121, align 8
  %.1125 = call i32 @dense_weight.54(ptr nonnull %.1121, ptr nonnull %excinfo.6, ptr %arg.method, i64 %.1024.0910, double %.925)
  switch i32 %.1125, label %B1598.if [
    i32 -2, label %B1598.endif
    i32 0, label %B1598.endif
  ]

B1598.if:
  %.1133 = icmp sgt i32 %.1125, 0
  %.1126 = load ptr, ptr %excinfo.6, align 8
  %.1134 = select i1 %.1133, ptr %.1126, ptr undef
  store ptr %.1134, ptr %excinfo, align 8
  br label %common.ret

B1598.endif:
  %.1135 = load double, ptr %.1121, align 8
  %.1147 = mul nsw i64 %.1024.0910, %.98
  %.1149 = getelementptr double, ptr %.141, i64 %.1147
  store ptr null, ptr %.1152, align 8
  %.1156 = call i32 @add_scaled.29(ptr nonnull %.1152, ptr nonnull %excinfo.7, i64 %.98, double %.1135, ptr %.905, ptr %.1149)
  switch i32 %.1156, label %B1598.endif.if [
    i32 -2, label %B1598.endif.endif
    i32 0, label %B1598.endif.endif
  ]

B1598.endif.if:
  %.1164 = icmp sgt i32 %.1156, 0
  %.1157 = load ptr, ptr %excinfo.7, align 8
  %.1165 = select i1 %.1164, ptr %.1157, ptr undef
  store ptr %.1165, ptr %excinfo, align 8
  br label %common.ret

B1598.endif.endif:
  %exitcond1190.not = icmp eq i64 %.1093, 8
  br i1 %exitcond1190.not, label %B1706, label %B1596.if

B1706.if:
  %.1201 = icmp sgt i32 %.1193, 0
  %.1194 = load ptr, ptr %excinfo.8, align 8
  %.1202 = select i1 %.1201, ptr %.1194, ptr undef
  store ptr %.1202, ptr %excinfo, align 8
  br label %common.ret

B1706.endif:
  store double 0.000000e+00, ptr %.1217, align 8
  %.1221 = call i32 @dot.51(ptr nonnull %.1217, ptr nonnull %excinfo.9, i64 %.98, ptr %.905, ptr %.153)
  switch i32 %.1221, label %B1706.endif.if [
    i32 -2, label %B1706.endif.endif
    i32 0, label %B1706.endif.endif
  ]

B1706.endif.if:
  %.1229 = icmp sgt i32 %.1221, 0
  %.1222 = load ptr, ptr %excinfo.9, align 8
  %.1230 = select i1 %.1229, ptr %.1222, ptr undef
  store ptr %.1230, ptr %excinfo, align 8
  br label %common.ret

B1706.endif.endif:
  %.1231 = load double, ptr %.1217, align 8
  %.1244 = fmul contract double %.925, %.1231
  %.1251 = fdiv contract double %.1244, %.394
  %.1253 = fsub contract double %h_bar.6.1915, %.1251
  %.1260 = fdiv contract double %.1231, %.394
  %.1262 = fsub contract double %time_bar.4.1916, %.1260
  %.864 = icmp sgt i64 %.811.0914, 1
  br i1 %.864, label %B1392.if, label %B1822

B1822.if:
  %.1312 = icmp sgt i32 %.1304, 0
  %.1305 = load ptr, ptr %excinfo.10, align 8
  %.1313 = select i1 %.1312, ptr %.1305, ptr undef
  store ptr %.1313, ptr %excinfo, align 8
  br label %common.ret

B1822.endif:
  %.1326 = load double, ptr %.1325, align 8
  %.1328 = fmul contract double %.394, %.1326
  %.1332 = fdiv contract double 1.000000e+00, %.1328
  br label %B1992.if

B1992.if:
  %time_bar.5.1932 = phi double [ %time_bar.4.1.lcssa, %B1822.endif ], [ %.1898, %B3096.endif.endif.endif ]
  %h_bar.7.1931 = phi double [ %h_bar.6.1.lcssa, %B1822.endif ], [ %.2367, %B3096.endif.endif.endif ]
  %.1359.0929 = phi i64 [ 0, %B1822.endif ], [ %.1429, %B3096.endif.endif.endif ]
  %.1429 = add nuw nsw i64 %.1359.0929, 1
  %35 = sub nuw nsw i64 7, %.1359.0929
  %.1461 = mul nsw i64 %35, %.98
  %.1463 = getelementptr double, ptr %.144, i64 %.1461
  %.1472 = getelementptr double, ptr %.141, i64 %.1461
  store ptr null, ptr %.1482, align 8
  %.1486 = call i32 @lu_solve_transposed.35(ptr nonnull %.1482, ptr nonnull %excinfo.11, i64 %.98, ptr %arg.slots, i64 %arg.blocks, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %.202, ptr %.1472, ptr %.1463, ptr %.195)
  switch i32 %.1486, label %B1994.if [
    i32 -2, label %B1994.endif
    i32 0, label %B1994.endif
  ]

B1994.if:
  %.1494 = icmp sgt i32 %.1486, 0
  %.1487 = load ptr, ptr %excinfo.11, align 8
  %.1495 = select i1 %.1494, ptr %.1487, ptr undef
  store ptr %.1495, ptr %excinfo, align 8
  br label %common.ret

B1994.endif:
  %.1511 = getelementptr double, ptr %.132, i64 %.1461
  store ptr null, ptr %.1514, align 8
  %.1518 = call i32 @copy.27(ptr nonnull %.1514, ptr nonnull %excinfo.12, i64 %.98, ptr %.1511, ptr %arg.Y)
  switch i32 %.1518, label %B1994.endif.if [
    i32 -2, label %B1994.endif.endif
    i32 0, label %B1994.endif.endif
  ]

B1994.endif.if:
  %.1526 = icmp sgt i32 %.1518, 0
  %.1519 = load ptr, ptr %excinfo.12, align 8
  %.1527 = select i1 %.1526, ptr %.1519, ptr undef
  store ptr %.1527, ptr %excinfo, align 8
  br label %common.ret

B1994.endif.endif:
  %36 = getelementptr double, ptr %arg.method, i64 %35
  %.1541 = getelementptr i8, ptr %36, i64 1024
  %.1542 = load double, ptr %.1541, align 8
  %.1544 = fmul contract double %.394, %.1542
  %.1546 = fadd contract double %.391, %.1544
  store double %.1546, ptr %.1549, align 8
  store ptr null, ptr %.1560, align 8
  %.1564 = call i32 @drive.6(ptr nonnull %.1560, ptr nonnull %excinfo.13, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.238, ptr %.246)
  switch i32 %.1564, label %B1994.endif.endif.if [
    i32 -2, label %B1994.endif.endif.endif
    i32 0, label %B1994.endif.endif.endif
  ]

B1994.endif.endif.if:
  %.1572 = icmp sgt i32 %.1564, 0
  %.1565 = load ptr, ptr %excinfo.13, align 8
  %.1573 = select i1 %.1572, ptr %.1565, ptr undef
  store ptr %.1573, ptr %excinfo, align 8
  br label %common.ret

B1994.endif.endif.endif:
  br i1 %.1665918, label %B2340.if.preheader, label %B2356

B2340.if.preheader:
  call void @llvm.memset.p0.i64(ptr align 8 %arg.Y_bar, i8 0, i64 %9, i1 false)
  br label %B2356

B2356.if:
  %.1727 = icmp sgt i32 %.1719, 0
  %.1720 = load ptr, ptr %excinfo.14, align 8
  %.1728 = select i1 %.1727, ptr %.1720, ptr undef
  store ptr %.1728, ptr %excinfo, align 8
  br label %common.ret

B2356.endif:
  store double 0.000000e+00, ptr %.1741, align 8
  store ptr null, ptr %.1755, align 8
  %.1759 = call i32 @pull_residual.39(ptr nonnull %.1755, ptr nonnull %excinfo.15, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.153, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %.238, ptr %.246)
  switch i32 %.1759, label %B2356.endif.if [
    i32 -2, label %B2356.endif.endif
    i32 0, label %B2356.endif.endif
  ]

B2356.endif.if:
  %.1767 = icmp sgt i32 %.1759, 0
  %.1760 = load ptr, ptr %excinfo.15, align 8
  %.1768 = select i1 %.1767, ptr %.1760, ptr undef
  store ptr %.1768, ptr %excinfo, align 8
  br label %common.ret

B2356.endif.endif:
  store ptr null, ptr %.1791, align 8
  %.1795 = call i32 @drives_bar.40(ptr nonnull %.1791, ptr nonnull %excinfo.16, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %.229, ptr %.238, ptr %.246)
  switch i32 %.1795, label %B2356.endif.endif.if [
    i32 -2, label %B2356.endif.endif.endif
    i32 0, label %B2356.endif.endif.endif
  ]

B2356.endif.endif.if:
  %.1803 = icmp sgt i32 %.1795, 0
  %.1796 = load ptr, ptr %excinfo.16, align 8
  %.1804 = select i1 %.1803, ptr %.1796, ptr undef
  store ptr %.1804, ptr %excinfo, align 8
  br label %common.ret

B2356.endif.endif.endif:
  %.1817 = icmp eq i64 %.1359.0929, 0
  br i1 %.1817, label %B2528, label %B2564

B2528.if:
  %.1835 = icmp sgt i32 %.1827, 0
  %.1828 = load ptr, ptr %excinfo.17, align 8
  %.1836 = select i1 %.1835, ptr %.1828, ptr undef
  store ptr %.1836, ptr %excinfo, align 8
  br label %common.ret

B2564.if:
  %.1864 = icmp sgt i32 %.1856, 0
  %.1857 = load ptr, ptr %excinfo.18, align 8
  %.1865 = select i1 %.1864, ptr %.1857, ptr undef
  store ptr %.1865, ptr %excinfo, align 8
  br label %common.ret

B2564.endif:
  %.1880 = load double, ptr %.1541, align 8
  %.1884 = load double, ptr %.1883, align 8
  %.1885 = fmul contract double %.1880, %.1884
  %.1887 = fadd contract double %h_bar.7.1931, %.1885
  %.1898 = fadd contract double %time_bar.5.1932, %.1884
  br i1 %.1984921.not, label %B2760, label %B2708.if

B2708.if:
  %.1928.0922 = phi i64 [ %.1997, %B2708.if ], [ 0, %B2564.endif ]
  %.1997 = add nuw nsw i64 %.1928.0922, 1
  %.2023 = getelementptr double, ptr %arg.mass, i64 %.1928.0922
  %.2024 = load double, ptr %.2023, align 8
  %.2026 = getelementptr double, ptr %.1463, i64 %.1928.0922
  %.2027 = load double, ptr %.2026, align 8
  %.2028 = fmul contract double %.2024, %.2027
  %.2033 = fdiv contract double %.2028, %.394
  %.2035 = getelementptr double, ptr %.157, i64 %.1928.0922
  store double %.2033, ptr %.2035, align 8
  %exitcond1191.not = icmp eq i64 %.98, %.1997
  br i1 %exitcond1191.not, label %B2760, label %B2708.if

B2790.if:
  %h_bar.8.2927 = phi double [ %.1887, %B2790.if.lr.ph ], [ %.2282, %B2792.endif.endif.endif ]
  %.2072.0925 = phi i64 [ 0, %B2790.if.lr.ph ], [ %.2141, %B2792.endif.endif.endif ]
  %.2141 = add nuw nsw i64 %.2072.0925, 1
  %.2167 = mul nsw i64 %.2072.0925, %.98
  %.2169 = getelementptr double, ptr %.141, i64 %.2167
  %.2175 = getelementptr double, ptr %30, i64 %.2072.0925
  %.2176 = load double, ptr %.2175, align 8
  store ptr null, ptr %.2179, align 8
  %.2183 = call i32 @add_scaled.29(ptr nonnull %.2179, ptr nonnull %excinfo.19, i64 %.98, double %.2176, ptr %arg.Y_bar, ptr %.2169)
  switch i32 %.2183, label %B2792.if [
    i32 -2, label %B2792.endif
    i32 0, label %B2792.endif
  ]

B2792.if:
  %.2191 = icmp sgt i32 %.2183, 0
  %.2184 = load ptr, ptr %excinfo.19, align 8
  %.2192 = select i1 %.2191, ptr %.2184, ptr undef
  store ptr %.2192, ptr %excinfo, align 8
  br label %common.ret

B2792.endif:
  %.2209 = getelementptr double, ptr %31, i64 %.2072.0925
  %.2210 = load double, ptr %.2209, align 8
  store ptr null, ptr %.2213, align 8
  %.2217 = call i32 @add_scaled.29(ptr nonnull %.2213, ptr nonnull %excinfo.20, i64 %.98, double %.2210, ptr %.157, ptr %.2169)
  switch i32 %.2217, label %B2792.endif.if [
    i32 -2, label %B2792.endif.endif
    i32 0, label %B2792.endif.endif
  ]

B2792.endif.if:
  %.2225 = icmp sgt i32 %.2217, 0
  %.2218 = load ptr, ptr %excinfo.20, align 8
  %.2226 = select i1 %.2225, ptr %.2218, ptr undef
  store ptr %.2226, ptr %excinfo, align 8
  br label %common.ret

B2792.endif.endif:
  %.2243 = load double, ptr %.2209, align 8
  %.2248 = getelementptr double, ptr %arg.work, i64 %.2167
  store double 0.000000e+00, ptr %.2251, align 8
  %.2255 = call i32 @dot.51(ptr nonnull %.2251, ptr nonnull %excinfo.21, i64 %.98, ptr %.157, ptr %.2248)
  switch i32 %.2255, label %B2792.endif.endif.if [
    i32 -2, label %B2792.endif.endif.endif
    i32 0, label %B2792.endif.endif.endif
  ]

B2792.endif.endif.if:
  %.2263 = icmp sgt i32 %.2255, 0
  %.2256 = load ptr, ptr %excinfo.21, align 8
  %.2264 = select i1 %.2263, ptr %.2256, ptr undef
  store ptr %.2264, ptr %excinfo, align 8
  br label %common.ret

B2792.endif.endif.endif:
  %.2265 = load double, ptr %.2251, align 8
  %.2275 = fmul contract double %.2243, %.2265
  %.2280 = fdiv contract double %.2275, %.394
  %.2282 = fsub contract double %h_bar.8.2927, %.2280
  %exitcond1192.not = icmp eq i64 %.2141, %35
  br i1 %exitcond1192.not, label %B3096, label %B2790.if

B3096.if:
  %.2315 = icmp sgt i32 %.2307, 0
  %.2308 = load ptr, ptr %excinfo.22, align 8
  %.2316 = select i1 %.2315, ptr %.2308, ptr undef
  store ptr %.2316, ptr %excinfo, align 8
  br label %common.ret

B3096.endif:
  %.2317 = load double, ptr %.2303, align 8
  %.2336 = getelementptr i8, ptr %36, i64 1088
  %.2337 = load double, ptr %.2336, align 8
  store double 0.000000e+00, ptr %.2342, align 8
  %.2346 = call i32 @dot.51(ptr nonnull %.2342, ptr nonnull %excinfo.23, i64 %.98, ptr %.1463, ptr %.161)
  switch i32 %.2346, label %B3096.endif.if [
    i32 -2, label %B3096.endif.endif
    i32 0, label %B3096.endif.endif
  ]

B3096.endif.if:
  %.2354 = icmp sgt i32 %.2346, 0
  %.2347 = load ptr, ptr %excinfo.23, align 8
  %.2355 = select i1 %.2354, ptr %.2347, ptr undef
  store ptr %.2355, ptr %excinfo, align 8
  br label %common.ret

B3096.endif.endif:
  %.2356 = load double, ptr %.2342, align 8
  %.2377 = load double, ptr %.2336, align 8
  %.2379 = fmul contract double %.394, %.2377
  store ptr null, ptr %.2383, align 8
  %.2387 = call i32 @add_scaled.29(ptr nonnull %.2383, ptr nonnull %excinfo.24, i64 %.98, double %.2379, ptr %.1463, ptr %.174)
  switch i32 %.2387, label %B3096.endif.endif.if [
    i32 -2, label %B3096.endif.endif.endif
    i32 0, label %B3096.endif.endif.endif
  ]

B3096.endif.endif.if:
  %.2395 = icmp sgt i32 %.2387, 0
  %.2388 = load ptr, ptr %excinfo.24, align 8
  %.2396 = select i1 %.2395, ptr %.2388, ptr undef
  store ptr %.2396, ptr %excinfo, align 8
  br label %common.ret

B3096.endif.endif.endif:
  %.2328 = fmul contract double %.1332, %.2317
  %.2330 = fadd contract double %h_bar.8.2.lcssa, %.2328
  %.2366 = fmul contract double %.2337, %.2356
  %.2367 = fadd contract double %.2330, %.2366
  %exitcond1193.not = icmp eq i64 %.1429, 8
  br i1 %exitcond1193.not, label %B3324, label %B1992.if

B3400.if:
  %.2568.0942 = phi i64 [ %.2637, %B3542 ], [ 0, %B3370 ]
  %.2789 = getelementptr i32, ptr %arg.entry_rows, i64 %.2568.0942
  %.2790 = load i32, ptr %.2789, align 4
  %.2791 = sext i32 %.2790 to i64
  %invariant.gep = getelementptr double, ptr %.144, i64 %.2791
  %.2800 = getelementptr i32, ptr %arg.entry_columns, i64 %.2568.0942
  %.2801 = load i32, ptr %.2800, align 4
  %.2802 = sext i32 %.2801 to i64
  %invariant.gep936 = getelementptr double, ptr %arg.work, i64 %.2802
  br label %B3448.if

B3448.if:
  %total.2.2940 = phi double [ 0.000000e+00, %B3400.if ], [ %.2809, %B3448.if ]
  %.2691.0938 = phi i64 [ 0, %B3400.if ], [ %.2760, %B3448.if ]
  %.2760 = add nuw nsw i64 %.2691.0938, 1
  %37 = mul nsw i64 %.2691.0938, %.98
  %gep = getelementptr double, ptr %invariant.gep, i64 %37
  %.2795 = load double, ptr %gep, align 8
  %gep937 = getelementptr double, ptr %invariant.gep936, i64 %37
  %.2806 = load double, ptr %gep937, align 8
  %.2807 = fmul contract double %.2795, %.2806
  %.2809 = fadd contract double %total.2.2940, %.2807
  %exitcond1194.not = icmp eq i64 %.2760, 8
  br i1 %exitcond1194.not, label %B3542, label %B3448.if

B3670.if:
  %.2988.0948 = phi i64 [ %.3057, %B3670.if ], [ 0, %B3640 ]
  %.3057 = add nuw nsw i64 %.2988.0948, 1
  %.3083 = getelementptr i32, ptr %arg.drive_rows, i64 %.2988.0948
  %.3084 = load i32, ptr %.3083, align 4
  %.3086 = sext i32 %.3084 to i64
  %.3087 = getelementptr double, ptr %.174, i64 %.3086
  %.3088 = load double, ptr %.3087, align 8
  %.3090 = getelementptr i32, ptr %arg.drive_columns, i64 %.2988.0948
  %.3091 = load i32, ptr %.3090, align 4
  %.3093 = sext i32 %.3091 to i64
  %.3094 = getelementptr double, ptr %.220, i64 %.3093
  %.3095 = load double, ptr %.3094, align 8
  %.3096 = fmul contract double %.3088, %.3095
  %.3099 = add nsw i64 %.2988.0948, %.123
  %.3101 = getelementptr double, ptr %.214, i64 %.3099
  store double %.3096, ptr %.3101, align 8
  %.3108 = getelementptr double, ptr %.229, i64 %.3093
  %.3109 = load double, ptr %.3108, align 8
  %.3116 = load double, ptr %.3087, align 8
  %.3121 = getelementptr double, ptr %.208, i64 %.3099
  %.3122 = load double, ptr %.3121, align 8
  %.3123 = fmul contract double %.3116, %.3122
  %.3124 = fadd contract double %.3109, %.3123
  store double %.3124, ptr %.3108, align 8
  %exitcond1198.not = icmp eq i64 %.115, %.3057
  br i1 %exitcond1198.not, label %B3850, label %B3670.if

B3850.if:
  %.3150 = icmp sgt i32 %.3142, 0
  %.3143 = load ptr, ptr %excinfo.25, align 8
  %.3151 = select i1 %.3150, ptr %.3143, ptr undef
  store ptr %.3151, ptr %excinfo, align 8
  br label %common.ret

B3850.endif:
  store double %.391, ptr %.3167, align 8
  store ptr null, ptr %.3180, align 8
  %.3184 = call i32 @drive.6(ptr nonnull %.3180, ptr nonnull %excinfo.26, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.238, ptr %.246)
  switch i32 %.3184, label %B3850.endif.if [
    i32 -2, label %B3850.endif.endif
    i32 0, label %B3850.endif.endif
  ]

B3850.endif.if:
  %.3192 = icmp sgt i32 %.3184, 0
  %.3185 = load ptr, ptr %excinfo.26, align 8
  %.3193 = select i1 %.3192, ptr %.3185, ptr undef
  store ptr %.3193, ptr %excinfo, align 8
  br label %common.ret

B3850.endif.endif:
  br i1 %.3285950, label %B3974.if.preheader, label %B3990

B3974.if.preheader:
  call void @llvm.memset.p0.i64(ptr align 8 %arg.Y_bar, i8 0, i64 %29, i1 false)
  br label %B3990

B3990.if:
  %.3355 = icmp sgt i32 %.3347, 0
  %.3348 = load ptr, ptr %excinfo.27, align 8
  %.3356 = select i1 %.3355, ptr %.3348, ptr undef
  store ptr %.3356, ptr %excinfo, align 8
  br label %common.ret

B3990.endif:
  store ptr null, ptr %.3379, align 8
  %.3383 = call i32 @pull_jacobian.55(ptr nonnull %.3379, ptr nonnull %excinfo.28, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.pos, ptr %arg.numbers, ptr %arg.Y, ptr %.214, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %.238, ptr %.246)
  switch i32 %.3383, label %B3990.endif.if [
    i32 -2, label %B3990.endif.endif
    i32 0, label %B3990.endif.endif
  ]

B3990.endif.if:
  %.3391 = icmp sgt i32 %.3383, 0
  %.3384 = load ptr, ptr %excinfo.28, align 8
  %.3392 = select i1 %.3391, ptr %.3384, ptr undef
  store ptr %.3392, ptr %excinfo, align 8
  br label %common.ret

B3990.endif.endif:
  store ptr null, ptr %.3415, align 8
  %.3419 = call i32 @drives_bar.40(ptr nonnull %.3415, ptr nonnull %excinfo.29, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %.229, ptr %.238, ptr %.246)
  switch i32 %.3419, label %B3990.endif.endif.if [
    i32 -2, label %B3990.endif.endif.endif
    i32 0, label %B3990.endif.endif.endif
  ]

B3990.endif.endif.if:
  %.3427 = icmp sgt i32 %.3419, 0
  %.3420 = load ptr, ptr %excinfo.29, align 8
  %.3428 = select i1 %.3427, ptr %.3420, ptr undef
  store ptr %.3428, ptr %excinfo, align 8
  br label %common.ret

B3990.endif.endif.endif:
  %.3442 = load double, ptr %.3441, align 8
  %.3444 = fadd contract double %.1898, %.3442
  store ptr null, ptr %.3454, align 8
  %.3458 = call i32 @copy.27(ptr nonnull %.3454, ptr nonnull %excinfo.30, i64 %.98, ptr %.178, ptr %arg.y_bar)
  switch i32 %.3458, label %B3990.endif.endif.endif.if [
    i32 -2, label %B3990.endif.endif.endif.endif
    i32 0, label %B3990.endif.endif.endif.endif
  ]

B3990.endif.endif.endif.if:
  %.3466 = icmp sgt i32 %.3458, 0
  %.3459 = load ptr, ptr %excinfo.30, align 8
  %.3467 = select i1 %.3466, ptr %.3459, ptr undef
  store ptr %.3467, ptr %excinfo, align 8
  br label %common.ret

B3990.endif.endif.endif.endif:
  store ptr null, ptr %.3482, align 8
  %.3486 = call i32 @add_scaled.29(ptr nonnull %.3482, ptr nonnull %excinfo.31, i64 %.98, double 1.000000e+00, ptr %arg.Y_bar, ptr %arg.y_bar)
  switch i32 %.3486, label %B3990.endif.endif.endif.endif.if [
    i32 -2, label %B3990.endif.endif.endif.endif.endif
    i32 0, label %B3990.endif.endif.endif.endif.endif
  ]

B3990.endif.endif.endif.endif.if:
  %.3494 = icmp sgt i32 %.3486, 0
  %.3487 = load ptr, ptr %excinfo.31, align 8
  %.3495 = select i1 %.3494, ptr %.3487, ptr undef
  store ptr %.3495, ptr %excinfo, align 8
  br label %common.ret

B3990.endif.endif.endif.endif.endif:
  %.3507 = icmp eq i64 %.326.sroa.0.0960, 0
  br i1 %.3507, label %B4246, label %B4278
}

define internal i32 @replay.48(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.pos, ptr noalias %arg.numbers, ptr noalias %arg.drive_rows, ptr noalias %arg.drive_columns, i64 %arg.blocks, ptr noalias %arg.own, ptr noalias %arg.slots, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.mass, ptr noalias %arg.method, ptr noalias %arg.step, ptr noalias %arg.Y, ptr noalias %arg.stages, ptr noalias %arg.places, ptr noalias %arg.J, ptr noalias %arg.rates, ptr noalias %arg.drift, ptr noalias %arg.lu, ptr noalias %arg.right, ptr noalias %arg.after, ptr noalias %arg.row, ptr noalias %arg.x, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.42 = alloca ptr, align 8
  store ptr null, ptr %.42, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.78 = alloca ptr, align 8
  store ptr null, ptr %.78, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.103 = alloca i64, align 8
  store i64 0, ptr %.103, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.128 = alloca ptr, align 8
  store ptr null, ptr %.128, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.158 = alloca ptr, align 8
  store ptr null, ptr %.158, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.186 = alloca ptr, align 8
  store ptr null, ptr %.186, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.35 = load i64, ptr %arg.layout, align 8
  %.37 = load double, ptr %arg.step, align 8
  %.38 = getelementptr i8, ptr %arg.step, i64 8
  %.39 = load double, ptr %.38, align 8
  %.40 = getelementptr i8, ptr %arg.step, i64 24
  store ptr null, ptr %.42, align 8
  %.46 = call i32 @linearise.22(ptr nonnull %.42, ptr nonnull %excinfo.1, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.pos, ptr %arg.numbers, ptr %arg.drive_rows, ptr %arg.drive_columns, double %.37, ptr %.40, ptr %arg.Y, ptr %arg.J, ptr %arg.rates, ptr %arg.drift, ptr %arg.local, ptr %arg.out)
  switch i32 %.46, label %B0.if [
    i32 -2, label %B0.endif
    i32 0, label %B0.endif
  ]

B0.if:
  %.54 = icmp sgt i32 %.46, 0
  %.47 = load ptr, ptr %excinfo.1, align 8
  %.55 = select i1 %.54, ptr %.47, ptr undef
  store ptr %.55, ptr %excinfo, align 8
  br label %common.ret

B0.endif:
  %.69 = getelementptr i32, ptr %arg.lu_start, i64 %arg.blocks
  %.70 = load i32, ptr %.69, align 4
  %.71 = getelementptr i8, ptr %arg.method, i64 1344
  %.72 = load double, ptr %.71, align 8
  %.73 = fmul contract double %.39, %.72
  %.77 = fdiv contract double 1.000000e+00, %.73
  store ptr null, ptr %.78, align 8
  %.82 = call i32 @lu_fill.23(ptr nonnull %.78, ptr nonnull %excinfo.2, i64 %.35, i32 %.70, ptr %arg.J, ptr %arg.own, ptr %arg.mass, double %.77, ptr %arg.lu)
  switch i32 %.82, label %B0.endif.endif.if [
    i32 -2, label %B0.endif.endif.endif
    i32 0, label %B0.endif.endif.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ %.162, %B0.endif.endif.endif.endif.endif.if ], [ %.46, %B0.if ], [ %.82, %B0.endif.endif.if ], [ %.107, %B0.endif.endif.endif.if ], [ %.132, %B0.endif.endif.endif.endif.if ], [ 0, %B0.endif.endif.endif.endif.endif.endif.endif ], [ %.190, %B0.endif.endif.endif.endif.endif.endif.if ]
  ret i32 %common.ret.op

B0.endif.endif.if:
  %.90 = icmp sgt i32 %.82, 0
  %.83 = load ptr, ptr %excinfo.2, align 8
  %.91 = select i1 %.90, ptr %.83, ptr undef
  store ptr %.91, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif:
  store i64 0, ptr %.103, align 8
  %.107 = call i32 @lu_factor.17(ptr nonnull %.103, ptr nonnull %excinfo.3, i64 %arg.blocks, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %arg.lu, ptr %arg.row)
  switch i32 %.107, label %B0.endif.endif.endif.if [
    i32 -2, label %B0.endif.endif.endif.endif
    i32 0, label %B0.endif.endif.endif.endif
  ]

B0.endif.endif.endif.if:
  %.115 = icmp sgt i32 %.107, 0
  %.108 = load ptr, ptr %excinfo.3, align 8
  %.116 = select i1 %.115, ptr %.108, ptr undef
  store ptr %.116, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endif:
  store ptr null, ptr %.128, align 8
  %.132 = call i32 @solve_stages.56(ptr nonnull %.128, ptr nonnull %excinfo.4, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, i64 %arg.blocks, ptr %arg.slots, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %arg.mass, ptr %arg.method, double %.37, double %.39, ptr %.40, ptr %arg.Y, ptr %arg.drift, ptr %arg.lu, ptr %arg.stages, ptr %arg.places, i64 %.35, ptr %arg.right, ptr %arg.after, ptr %arg.x, ptr %arg.local, ptr %arg.out)
  switch i32 %.132, label %B0.endif.endif.endif.endif.if [
    i32 -2, label %B0.endif.endif.endif.endif.endif
    i32 0, label %B0.endif.endif.endif.endif.endif
  ]

B0.endif.endif.endif.endif.if:
  %.140 = icmp sgt i32 %.132, 0
  %.133 = load ptr, ptr %excinfo.4, align 8
  %.141 = select i1 %.140, ptr %.133, ptr undef
  store ptr %.141, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endif.endif:
  %.153.idx = shl i64 %.35, 6
  %.153 = getelementptr i8, ptr %arg.places, i64 %.153.idx
  %.156 = mul nsw i64 %.35, 7
  %.157 = getelementptr double, ptr %arg.places, i64 %.156
  store ptr null, ptr %.158, align 8
  %.162 = call i32 @copy.27(ptr nonnull %.158, ptr nonnull %excinfo.5, i64 %.35, ptr %.157, ptr %.153)
  switch i32 %.162, label %B0.endif.endif.endif.endif.endif.if [
    i32 -2, label %B0.endif.endif.endif.endif.endif.endif
    i32 0, label %B0.endif.endif.endif.endif.endif.endif
  ]

B0.endif.endif.endif.endif.endif.if:
  %.170 = icmp sgt i32 %.162, 0
  %.163 = load ptr, ptr %excinfo.5, align 8
  %.171 = select i1 %.170, ptr %.163, ptr undef
  store ptr %.171, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endif.endif.endif:
  %.185 = getelementptr double, ptr %arg.stages, i64 %.156
  store ptr null, ptr %.186, align 8
  %.190 = call i32 @add_scaled.29(ptr nonnull %.186, ptr nonnull %excinfo.6, i64 %.35, double 1.000000e+00, ptr %.185, ptr %.153)
  switch i32 %.190, label %B0.endif.endif.endif.endif.endif.endif.if [
    i32 -2, label %B0.endif.endif.endif.endif.endif.endif.endif
    i32 0, label %B0.endif.endif.endif.endif.endif.endif.endif
  ]

B0.endif.endif.endif.endif.endif.endif.if:
  %.198 = icmp sgt i32 %.190, 0
  %.191 = load ptr, ptr %excinfo.6, align 8
  %.199 = select i1 %.198, ptr %.191, ptr undef
  store ptr %.199, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endif.endif.endif.endif:
  store ptr null, ptr %retptr, align 8
  br label %common.ret
}

define internal i32 @first_edge_in.49(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.edges, i64 %arg.stop, double %arg.time) noinline {
entry:
  %.19 = icmp sgt i64 %arg.stop, 0
  br i1 %.19, label %B20, label %B114

B20:
  %0 = getelementptr double, ptr %arg.edges, i64 %arg.stop
  %.33 = getelementptr i8, ptr %0, i64 -8
  %.34 = load double, ptr %.33, align 8
  %.36 = fmul contract double %arg.time, 0x3FF0000000000005
  %.37 = fcmp contract ogt double %.34, %.36
  br i1 %.37, label %B56, label %B114

B56:
  %first.2.0 = phi i64 [ %.43, %B78 ], [ %arg.stop, %B20 ]
  %.53 = icmp sgt i64 %first.2.0, 1
  br i1 %.53, label %B78, label %B114

B78:
  %.43 = add nsw i64 %first.2.0, -1
  %1 = getelementptr double, ptr %arg.edges, i64 %first.2.0
  %.66 = getelementptr i8, ptr %1, i64 -16
  %.67 = load double, ptr %.66, align 8
  %.70 = fcmp contract ogt double %.67, %.36
  br i1 %.70, label %B56, label %B114

B114:
  %first.3.1 = phi i64 [ %arg.stop, %B20 ], [ %arg.stop, %entry ], [ %.43, %B78 ], [ 0, %B56 ]
  store i64 %first.3.1, ptr %retptr, align 8
  ret i32 0
}

define internal i32 @part_done.53(ptr noalias %retptr, ptr noalias %excinfo, double %arg.edge, ptr noalias %arg.step) noinline {
entry:
  %.20 = alloca double, align 8
  store double 0.000000e+00, ptr %.20, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.7 = load double, ptr %arg.step, align 8
  %.8 = fsub contract double %arg.edge, %.7
  %.9 = getelementptr i8, ptr %arg.step, i64 16
  %.10 = load double, ptr %.9, align 8
  %.13 = fsub contract double %.10, %.7
  %.17 = fdiv contract double %.8, %.13
  store double 0.000000e+00, ptr %.20, align 8
  %.26 = call i32 @numba.21(ptr nonnull %.20, ptr nonnull %excinfo.1, double %.17, double 1.000000e+00)
  switch i32 %.26, label %B0.endif.if [
    i32 -2, label %B0.endif.endif
    i32 0, label %B0.endif.endif
  ]

B0.endif.if:
  %.34 = icmp sgt i32 %.26, 0
  %.27 = load ptr, ptr %excinfo.1, align 8
  %.35 = select i1 %.34, ptr %.27, ptr undef
  store ptr %.35, ptr %excinfo, align 8
  br label %common.ret

common.ret:
  %common.ret.op = phi i32 [ 0, %B0.endif.endif ], [ %.26, %B0.endif.if ]
  ret i32 %common.ret.op

B0.endif.endif:
  %.36 = load double, ptr %.20, align 8
  store double %.36, ptr %retptr, align 8
  br label %common.ret
}

define internal i32 @dense_weight.54(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.method, i64 %arg.j, double %arg.theta) noinline {
entry:
  %0 = getelementptr double, ptr %arg.method, i64 %arg.j
  %.9 = getelementptr i8, ptr %0, i64 1216
  %.10 = load double, ptr %.9, align 8
  %.14 = getelementptr i8, ptr %0, i64 1280
  %.15 = load double, ptr %.14, align 8
  %.16 = fmul contract double %arg.theta, %.15
  %.17 = fadd contract double %.10, %.16
  %.19 = fsub contract double 1.000000e+00, %arg.theta
  %.20 = fmul contract double %arg.theta, %.19
  %.22 = getelementptr i8, ptr %0, i64 1152
  %.23 = load double, ptr %.22, align 8
  %.24 = fmul contract double %arg.theta, %.17
  %.25 = fadd contract double %.23, %.24
  %.26 = fmul contract double %.20, %.25
  store double %.26, ptr %retptr, align 8
  ret i32 0
}

define internal i32 @dense_rate.50(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.method, double %arg.theta, ptr noalias %arg.y, ptr noalias %arg.end, ptr noalias %arg.stages, ptr noalias %arg.rate) noinline {
entry:
  %.327 = alloca ptr, align 8
  store ptr null, ptr %.327, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.10772.not = icmp slt i64 %arg.n, 1
  br i1 %.10772.not, label %B120.preheader, label %B34.if

B120.preheader:
  %.304 = fmul contract double %arg.theta, 2.000000e+00
  %.306 = fsub contract double 1.000000e+00, %.304
  %.310 = fsub contract double 1.000000e+00, %arg.theta
  %.312 = fmul contract double %arg.theta, %.310
  br label %B120.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B422 ], [ %.331, %B122.if ]
  ret i32 %common.ret.op

B422:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B34.if:
  %.49.073 = phi i64 [ %.120, %B34.if ], [ 0, %entry ]
  %.120 = add nuw nsw i64 %.49.073, 1
  %.146 = getelementptr double, ptr %arg.end, i64 %.49.073
  %.147 = load double, ptr %.146, align 8
  %.149 = getelementptr double, ptr %arg.y, i64 %.49.073
  %.150 = load double, ptr %.149, align 8
  %.151 = fsub contract double %.147, %.150
  %.153 = getelementptr double, ptr %arg.rate, i64 %.49.073
  store double %.151, ptr %.153, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.120
  br i1 %exitcond.not, label %B120.preheader, label %B34.if

B120.if:
  %.187.075 = phi i64 [ 0, %B120.preheader ], [ %.256, %B122.endif ]
  %0 = getelementptr double, ptr %arg.method, i64 %.187.075
  %.283 = getelementptr i8, ptr %0, i64 1152
  %.284 = load double, ptr %.283, align 8
  %.288 = getelementptr i8, ptr %0, i64 1216
  %.289 = load double, ptr %.288, align 8
  %.294 = getelementptr i8, ptr %0, i64 1280
  %.295 = load double, ptr %.294, align 8
  %.297 = fmul contract double %arg.theta, %.295
  %.298 = fadd contract double %.289, %.297
  %.300 = fmul contract double %arg.theta, %.298
  %.301 = fadd contract double %.284, %.300
  %.307 = fmul contract double %.306, %.301
  %.316 = fmul contract double %.304, %.295
  %.317 = fadd contract double %.289, %.316
  %.318 = fmul contract double %.312, %.317
  %.319 = fadd contract double %.318, %.307
  %.322 = mul nsw i64 %.187.075, %arg.n
  %.324 = getelementptr double, ptr %arg.stages, i64 %.322
  store ptr null, ptr %.327, align 8
  %.331 = call i32 @add_scaled.29(ptr nonnull %.327, ptr nonnull %excinfo.1, i64 %arg.n, double %.319, ptr %.324, ptr %arg.rate)
  switch i32 %.331, label %B122.if [
    i32 -2, label %B122.endif
    i32 0, label %B122.endif
  ]

B122.if:
  %.339 = icmp sgt i32 %.331, 0
  %.332 = load ptr, ptr %excinfo.1, align 8
  %.340 = select i1 %.339, ptr %.332, ptr undef
  store ptr %.340, ptr %excinfo, align 8
  br label %common.ret

B122.endif:
  %.256 = add nuw nsw i64 %.187.075, 1
  %exitcond78.not = icmp eq i64 %.256, 8
  br i1 %exitcond78.not, label %B422, label %B120.if
}

define internal i32 @dot.51(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y) noinline {
entry:
  %.9534.not = icmp slt i64 %arg.n, 1
  br i1 %.9534.not, label %B84, label %B38.if

B84:
  %total.2.0.lcssa = phi double [ 0.000000e+00, %entry ], [ %.141, %B38.if ]
  store double %total.2.0.lcssa, ptr %retptr, align 8
  ret i32 0

B38.if:
  %total.2.037 = phi double [ %.141, %B38.if ], [ 0.000000e+00, %entry ]
  %.37.035 = phi i64 [ %.108, %B38.if ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.035, 1
  %.134 = getelementptr double, ptr %arg.x, i64 %.37.035
  %.135 = load double, ptr %.134, align 8
  %.137 = getelementptr double, ptr %arg.y, i64 %.37.035
  %.138 = load double, ptr %.137, align 8
  %.139 = fmul contract double %.135, %.138
  %.141 = fadd contract double %total.2.037, %.139
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B84, label %B38.if
}

define internal i32 @pull_drive.52(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, i64 %arg.which, ptr noalias %arg.weights, ptr noalias %arg.Y_bar, ptr noalias %arg.numbers_bar, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.190 = alloca ptr, align 8
  store ptr null, ptr %.190, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.41 = getelementptr i8, ptr %arg.layout, i64 40
  %.42 = load i64, ptr %.41, align 8
  %.12436.not = icmp slt i64 %.42, 1
  br i1 %.12436.not, label %B266, label %B56.if.lr.ph

B56.if.lr.ph:
  %.163 = getelementptr i8, ptr %arg.layout, i64 32
  br label %B56.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B266 ], [ %.194, %B58.if ]
  ret i32 %common.ret.op

B266:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B56.if:
  %.66.037 = phi i64 [ 0, %B56.if.lr.ph ], [ %.137, %B58.endif ]
  %.164 = load i64, ptr %.163, align 8
  %.165 = add nsw i64 %.164, %.66.037
  %.166 = mul nsw i64 %.165, 11
  %.167 = add nsw i64 %.166, 8
  %0 = getelementptr i64, ptr %arg.layout, i64 %.166
  %.171 = getelementptr i8, ptr %0, i64 96
  %.172 = load i64, ptr %.171, align 8
  %.175 = getelementptr i8, ptr %0, i64 128
  %.176 = load i64, ptr %.175, align 8
  %.178 = getelementptr i32, ptr %arg.rows, i64 %.176
  store ptr null, ptr %.190, align 8
  %.194 = call i32 @pull.57(ptr nonnull %.190, ptr nonnull %excinfo.1, ptr %arg.layout, i64 %.167, i64 %arg.which, i64 %.172, ptr %.178, ptr %arg.derived, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.weights, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %arg.local, ptr %arg.out)
  switch i32 %.194, label %B58.if [
    i32 -2, label %B58.endif
    i32 0, label %B58.endif
  ]

B58.if:
  %.202 = icmp sgt i32 %.194, 0
  %.195 = load ptr, ptr %excinfo.1, align 8
  %.203 = select i1 %.202, ptr %.195, ptr undef
  store ptr %.203, ptr %excinfo, align 8
  br label %common.ret

B58.endif:
  %.137 = add nuw nsw i64 %.66.037, 1
  %exitcond.not = icmp eq i64 %.137, %.42
  br i1 %exitcond.not, label %B266, label %B56.if
}

define internal i32 @pull_jacobian.55(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.pos, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.weights, ptr noalias %arg.Y_bar, ptr noalias %arg.numbers_bar, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.363 = alloca ptr, align 8
  store ptr null, ptr %.363, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.38 = getelementptr i8, ptr %arg.layout, i64 32
  %.39 = load i64, ptr %.38, align 8
  %.12182.not = icmp slt i64 %.39, 1
  br i1 %.12182.not, label %B508, label %B56.if

B206:
  %.184 = getelementptr i8, ptr %2, i64 56
  %.185 = load i64, ptr %.184, align 8
  %.187 = getelementptr double, ptr %arg.numbers_bar, i64 %.185
  %.194 = getelementptr i8, ptr %2, i64 8
  %.195 = load i64, ptr %.194, align 8
  %.202 = load i64, ptr %2, align 8
  %.203 = mul nsw i64 %.202, %.195
  %.28379.not = icmp slt i64 %.203, 1
  br i1 %.28379.not, label %B509, label %B358.if

B422:
  %.349 = getelementptr i8, ptr %2, i64 40
  %.350 = load i64, ptr %.349, align 8
  store ptr null, ptr %.363, align 8
  %.367 = call i32 @pull.57(ptr nonnull %.363, ptr nonnull %excinfo.1, ptr %arg.layout, i64 %1, i64 1, i64 %.350, ptr %.170, ptr %arg.derived, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.weights, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %arg.local, ptr %arg.out)
  switch i32 %.367, label %B422.if [
    i32 -2, label %B509
    i32 0, label %B509
  ]

common.ret:
  %common.ret.op = phi i32 [ 0, %B508 ], [ %.367, %B422.if ]
  ret i32 %common.ret.op

B508:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B509:
  %exitcond85.not = icmp eq i64 %.39, %.134
  br i1 %exitcond85.not, label %B508, label %B56.if

B56.if:
  %.63.083 = phi i64 [ %.134, %B509 ], [ 0, %entry ]
  %.134 = add nuw nsw i64 %.63.083, 1
  %0 = mul nuw nsw i64 %.63.083, 11
  %1 = add nuw nsw i64 %0, 8
  %2 = getelementptr i64, ptr %arg.layout, i64 %1
  %.167 = getelementptr i8, ptr %2, i64 72
  %.168 = load i64, ptr %.167, align 8
  %.170 = getelementptr i32, ptr %arg.pos, i64 %.168
  %.177 = getelementptr i8, ptr %2, i64 80
  %.178 = load i64, ptr %.177, align 8
  %.179 = icmp eq i64 %.178, -1
  br i1 %.179, label %B206, label %B422

B358.if:
  %.227.080 = phi i64 [ %.296, %B358.if ], [ 0, %B206 ]
  %.296 = add nuw nsw i64 %.227.080, 1
  %.322 = getelementptr double, ptr %.187, i64 %.227.080
  %.323 = load double, ptr %.322, align 8
  %.325 = getelementptr i32, ptr %.170, i64 %.227.080
  %.326 = load i32, ptr %.325, align 4
  %.328 = sext i32 %.326 to i64
  %.329 = getelementptr double, ptr %arg.weights, i64 %.328
  %.330 = load double, ptr %.329, align 8
  %.331 = fadd contract double %.323, %.330
  store double %.331, ptr %.322, align 8
  %exitcond.not = icmp eq i64 %.203, %.296
  br i1 %exitcond.not, label %B509, label %B358.if

B422.if:
  %.375 = icmp sgt i32 %.367, 0
  %.368 = load ptr, ptr %excinfo.1, align 8
  %.376 = select i1 %.375, ptr %.368, ptr undef
  store ptr %.376, ptr %excinfo, align 8
  br label %common.ret
}

define internal i32 @pull.57(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, i64 %arg.table, i64 %arg.which, i64 %arg.results, ptr noalias %arg.places, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.weights, ptr noalias %arg.Y_bar, ptr noalias %arg.numbers_bar, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.229 = alloca ptr, align 8
  store ptr null, ptr %.229, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.263 = alloca ptr, align 8
  store ptr null, ptr %.263, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.302 = alloca ptr, align 8
  store ptr null, ptr %.302, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %0 = getelementptr i64, ptr %arg.layout, i64 %arg.table
  %.45 = getelementptr i8, ptr %0, i64 8
  %.46 = load i64, ptr %.45, align 8
  %.47 = mul nsw i64 %.46, %arg.results
  %.51 = getelementptr i8, ptr %0, i64 24
  %.52 = load i64, ptr %.51, align 8
  %.53 = mul i64 %.52, %.46
  %.63 = getelementptr i8, ptr %0, i64 16
  %.64 = load i64, ptr %.63, align 8
  %.65 = mul nsw i64 %.64, %.46
  %.84 = load i64, ptr %0, align 8
  %.166102.not = icmp slt i64 %.84, 1
  br i1 %.166102.not, label %B690, label %B240.if.lr.ph

B240.if.lr.ph:
  %.72 = getelementptr i8, ptr %0, i64 80
  %.73 = load i64, ptr %.72, align 8
  %.207 = getelementptr i8, ptr %0, i64 48
  %.208 = load i64, ptr %.207, align 8
  %1 = getelementptr i32, ptr %arg.idx, i64 %.208
  %.217 = getelementptr i8, ptr %0, i64 56
  %.218 = load i64, ptr %.217, align 8
  %.260 = getelementptr double, ptr %arg.local, i64 %.65
  %.idx = shl i64 %.73, 4
  %2 = getelementptr i8, ptr %arg.derived, i64 %.idx
  %.294 = getelementptr i8, ptr %2, i64 8
  %.40699.not = icmp slt i64 %.53, 1
  %3 = getelementptr double, ptr %arg.out, i64 %.65
  br label %B240.if

B240.loopexit:
  %exitcond111.not = icmp eq i64 %.179, %.84
  br i1 %exitcond111.not, label %B690, label %B240.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B690 ], [ %.306, %B242.endif.endif.if ], [ %.267, %B242.endif.if ], [ %.233, %B242.if ]
  ret i32 %common.ret.op

B690:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B240.if:
  %.108.0103 = phi i64 [ 0, %B240.if.lr.ph ], [ %.179, %B240.loopexit ]
  %.179 = add nuw nsw i64 %.108.0103, 1
  %.210 = mul nsw i64 %.108.0103, %.65
  %.213 = getelementptr i32, ptr %1, i64 %.210
  %.220 = mul nsw i64 %.108.0103, %.53
  %.221 = add nsw i64 %.218, %.220
  store ptr null, ptr %.229, align 8
  %.233 = call i32 @gather.3(ptr nonnull %.229, ptr nonnull %excinfo.1, i64 %.65, ptr %.213, ptr %arg.Y, ptr %arg.local)
  switch i32 %.233, label %B242.if [
    i32 -2, label %B242.endif
    i32 0, label %B242.endif
  ]

B242.if:
  %.241 = icmp sgt i32 %.233, 0
  %.234 = load ptr, ptr %excinfo.1, align 8
  %.242 = select i1 %.241, ptr %.234, ptr undef
  store ptr %.242, ptr %excinfo, align 8
  br label %common.ret

B242.endif:
  %.255 = mul nsw i64 %.108.0103, %.47
  %.257 = getelementptr i32, ptr %arg.places, i64 %.255
  store ptr null, ptr %.263, align 8
  %.267 = call i32 @gather.3(ptr nonnull %.263, ptr nonnull %excinfo.2, i64 %.47, ptr %.257, ptr %arg.weights, ptr %.260)
  switch i32 %.267, label %B242.endif.if [
    i32 -2, label %B242.endif.endif
    i32 0, label %B242.endif.endif
  ]

B242.endif.if:
  %.275 = icmp sgt i32 %.267, 0
  %.268 = load ptr, ptr %excinfo.2, align 8
  %.276 = select i1 %.275, ptr %.268, ptr undef
  store ptr %.276, ptr %excinfo, align 8
  br label %common.ret

B242.endif.endif:
  %.289 = getelementptr double, ptr %arg.numbers, i64 %.221
  %.295 = load i64, ptr %.294, align 8
  %.296 = inttoptr i64 %.295 to ptr
  call void %.296(ptr %arg.local, ptr %.289, ptr %arg.out)
  store ptr null, ptr %.302, align 8
  %.306 = call i32 @scatter.2(ptr nonnull %.302, ptr nonnull %excinfo.3, i64 %.65, ptr %.213, ptr %arg.out, ptr %arg.Y_bar)
  switch i32 %.306, label %B242.endif.endif.if [
    i32 -2, label %B242.endif.endif.endif
    i32 0, label %B242.endif.endif.endif
  ]

B242.endif.endif.if:
  %.314 = icmp sgt i32 %.306, 0
  %.307 = load ptr, ptr %excinfo.3, align 8
  %.315 = select i1 %.314, ptr %.307, ptr undef
  store ptr %.315, ptr %excinfo, align 8
  br label %common.ret

B242.endif.endif.endif:
  br i1 %.40699.not, label %B240.loopexit, label %B626.if.lr.ph

B626.if.lr.ph:
  %4 = getelementptr double, ptr %arg.numbers_bar, i64 %.221
  br label %B626.if

B626.if:
  %.350.0100 = phi i64 [ 0, %B626.if.lr.ph ], [ %.419, %B626.if ]
  %.419 = add nuw nsw i64 %.350.0100, 1
  %.447 = getelementptr double, ptr %4, i64 %.350.0100
  %.448 = load double, ptr %.447, align 8
  %.452 = getelementptr double, ptr %3, i64 %.350.0100
  %.453 = load double, ptr %.452, align 8
  %.454 = fadd contract double %.448, %.453
  store double %.454, ptr %.447, align 8
  %exitcond.not = icmp eq i64 %.53, %.419
  br i1 %exitcond.not, label %B240.loopexit, label %B626.if
}

define internal i32 @solve_stages.56(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, i64 %arg.blocks, ptr noalias %arg.slots, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.mass, ptr noalias %arg.method, double %arg.time, double %arg.h, ptr noalias %arg.y, ptr noalias %arg.Y, ptr noalias %arg.drift, ptr noalias %arg.lu, ptr noalias %arg.stages, ptr noalias %arg.place_, i64 %arg.stride, ptr noalias %arg.right, ptr noalias %arg.after, ptr noalias %arg.x, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.226 = alloca ptr, align 8
  store ptr null, ptr %.226, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.381 = alloca ptr, align 8
  store ptr null, ptr %.381, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.423 = alloca ptr, align 8
  store ptr null, ptr %.423, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.457 = alloca ptr, align 8
  store ptr null, ptr %.457, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.486 = alloca ptr, align 8
  store ptr null, ptr %.486, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.538 = alloca ptr, align 8
  store ptr null, ptr %.538, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.572 = alloca ptr, align 8
  store ptr null, ptr %.572, align 8
  %excinfo.7 = alloca ptr, align 8
  store ptr null, ptr %excinfo.7, align 8
  %.609 = alloca ptr, align 8
  store ptr null, ptr %.609, align 8
  %excinfo.8 = alloca ptr, align 8
  store ptr null, ptr %excinfo.8, align 8
  %.651 = alloca ptr, align 8
  store ptr null, ptr %.651, align 8
  %excinfo.9 = alloca ptr, align 8
  store ptr null, ptr %excinfo.9, align 8
  %.697 = alloca ptr, align 8
  store ptr null, ptr %.697, align 8
  %excinfo.10 = alloca ptr, align 8
  store ptr null, ptr %excinfo.10, align 8
  %.84 = load i64, ptr %arg.layout, align 8
  %.412.not = icmp eq i64 %arg.stride, 0
  %.522 = getelementptr i8, ptr %arg.layout, i64 8
  %0 = getelementptr double, ptr %arg.Y, i64 %.84
  br label %B72.if

B136:
  store ptr null, ptr %.226, align 8
  %.230 = call i32 @copy.27(ptr nonnull %.226, ptr nonnull %excinfo.1, i64 %.84, ptr %arg.y, ptr %.215)
  switch i32 %.230, label %B136.if [
    i32 -2, label %B136.endif
    i32 0, label %B136.endif
  ]

B302:
  br i1 %.412.not, label %B388, label %B314

B314:
  %.416 = add nsw i64 %.111.0126, -1
  %.418 = mul nsw i64 %.416, %arg.stride
  %.420 = getelementptr double, ptr %arg.place_, i64 %.418
  store ptr null, ptr %.423, align 8
  %.427 = call i32 @copy.27(ptr nonnull %.423, ptr nonnull %excinfo.3, i64 %.84, ptr %.420, ptr %.215)
  switch i32 %.427, label %B314.if [
    i32 -2, label %B388
    i32 0, label %B388
  ]

B388:
  %.450 = add nsw i64 %.111.0126, -1
  %.452 = mul nsw i64 %.450, %.84
  %.454 = getelementptr double, ptr %arg.stages, i64 %.452
  store ptr null, ptr %.457, align 8
  %.461 = call i32 @add_scaled.29(ptr nonnull %.457, ptr nonnull %excinfo.4, i64 %.84, double 1.000000e+00, ptr %.454, ptr %.215)
  switch i32 %.461, label %B388.if [
    i32 -2, label %B464
    i32 0, label %B464
  ]

B464:
  store ptr null, ptr %.486, align 8
  %.490 = call i32 @copy.27(ptr nonnull %.486, ptr nonnull %excinfo.5, i64 %.84, ptr %.215, ptr %arg.Y)
  switch i32 %.490, label %B464.if [
    i32 -2, label %B464.endif
    i32 0, label %B464.endif
  ]

B810:
  store ptr null, ptr %.651, align 8
  %.655 = call i32 @add_scaled.29(ptr nonnull %.651, ptr nonnull %excinfo.9, i64 %.84, double %.639, ptr %arg.drift, ptr %arg.right)
  switch i32 %.655, label %B810.if [
    i32 -2, label %B846
    i32 0, label %B846
  ]

B846:
  %.682 = mul nsw i64 %.111.0126, %.84
  %.686 = getelementptr double, ptr %arg.stages, i64 %.682
  store ptr null, ptr %.697, align 8
  %.701 = call i32 @lu_solve.19(ptr nonnull %.697, ptr nonnull %excinfo.10, i64 %.84, ptr %arg.slots, i64 %arg.blocks, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %arg.lu, ptr %arg.right, ptr %.686, ptr %arg.x)
  switch i32 %.701, label %B846.if [
    i32 -2, label %B846.endif
    i32 0, label %B846.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ 0, %B936 ], [ %.701, %B846.if ], [ %.655, %B810.if ], [ %.613, %B464.endif.endif.endif.if ], [ %.230, %B136.if ], [ %.385, %B202.if ], [ %.427, %B314.if ], [ %.461, %B388.if ], [ %.490, %B464.if ], [ %.542, %B464.endif.if ], [ %.576, %B464.endif.endif.if ]
  ret i32 %common.ret.op

B936:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B72.if:
  %.111.0126 = phi i64 [ 0, %entry ], [ %.183, %B846.endif ]
  %.183 = add nuw nsw i64 %.111.0126, 1
  %.213 = mul nsw i64 %.111.0126, %arg.stride
  %.215 = getelementptr double, ptr %arg.place_, i64 %.213
  %.220 = icmp samesign ult i64 %.111.0126, 6
  br i1 %.220, label %B136, label %B302

B136.if:
  %.238 = icmp sgt i32 %.230, 0
  %.231 = load ptr, ptr %excinfo.1, align 8
  %.239 = select i1 %.238, ptr %.231, ptr undef
  store ptr %.239, ptr %excinfo, align 8
  br label %common.ret

B136.endif:
  %.330123.not = icmp eq i64 %.111.0126, 0
  br i1 %.330123.not, label %B464, label %B200.if.lr.ph

B200.if.lr.ph:
  %.idx107 = shl nuw nsw i64 %.111.0126, 6
  %1 = getelementptr i8, ptr %arg.method, i64 %.idx107
  br label %B200.if

B200.if:
  %.274.0124 = phi i64 [ 0, %B200.if.lr.ph ], [ %.343, %B202.endif ]
  %.373 = getelementptr double, ptr %1, i64 %.274.0124
  %.374 = load double, ptr %.373, align 8
  %.376 = mul nsw i64 %.274.0124, %.84
  %.378 = getelementptr double, ptr %arg.stages, i64 %.376
  store ptr null, ptr %.381, align 8
  %.385 = call i32 @add_scaled.29(ptr nonnull %.381, ptr nonnull %excinfo.2, i64 %.84, double %.374, ptr %.378, ptr %.215)
  switch i32 %.385, label %B202.if [
    i32 -2, label %B202.endif
    i32 0, label %B202.endif
  ]

B202.if:
  %.393 = icmp sgt i32 %.385, 0
  %.386 = load ptr, ptr %excinfo.2, align 8
  %.394 = select i1 %.393, ptr %.386, ptr undef
  store ptr %.394, ptr %excinfo, align 8
  br label %common.ret

B202.endif:
  %.343 = add nuw nsw i64 %.274.0124, 1
  %exitcond.not = icmp eq i64 %.343, %.111.0126
  br i1 %exitcond.not, label %B464, label %B200.if

B314.if:
  %.435 = icmp sgt i32 %.427, 0
  %.428 = load ptr, ptr %excinfo.3, align 8
  %.436 = select i1 %.435, ptr %.428, ptr undef
  store ptr %.436, ptr %excinfo, align 8
  br label %common.ret

B388.if:
  %.469 = icmp sgt i32 %.461, 0
  %.462 = load ptr, ptr %excinfo.4, align 8
  %.470 = select i1 %.469, ptr %.462, ptr undef
  store ptr %.470, ptr %excinfo, align 8
  br label %common.ret

B464.if:
  %.498 = icmp sgt i32 %.490, 0
  %.491 = load ptr, ptr %excinfo.5, align 8
  %.499 = select i1 %.498, ptr %.491, ptr undef
  store ptr %.499, ptr %excinfo, align 8
  br label %common.ret

B464.endif:
  %2 = getelementptr double, ptr %arg.method, i64 %.111.0126
  %.515 = getelementptr i8, ptr %2, i64 1024
  %.516 = load double, ptr %.515, align 8
  %.518 = fmul contract double %arg.h, %.516
  %.520 = fadd contract double %arg.time, %.518
  %.523 = load i64, ptr %.522, align 8
  %.527 = getelementptr double, ptr %0, i64 %.523
  store double %.520, ptr %.527, align 8
  store ptr null, ptr %.538, align 8
  %.542 = call i32 @drive.6(ptr nonnull %.538, ptr nonnull %excinfo.6, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.local, ptr %arg.out)
  switch i32 %.542, label %B464.endif.if [
    i32 -2, label %B464.endif.endif
    i32 0, label %B464.endif.endif
  ]

B464.endif.if:
  %.550 = icmp sgt i32 %.542, 0
  %.543 = load ptr, ptr %excinfo.6, align 8
  %.551 = select i1 %.550, ptr %.543, ptr undef
  store ptr %.551, ptr %excinfo, align 8
  br label %common.ret

B464.endif.endif:
  store ptr null, ptr %.572, align 8
  %.576 = call i32 @residual.0(ptr nonnull %.572, ptr nonnull %excinfo.7, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.right, ptr %arg.local, ptr %arg.out)
  switch i32 %.576, label %B464.endif.endif.if [
    i32 -2, label %B464.endif.endif.endif
    i32 0, label %B464.endif.endif.endif
  ]

B464.endif.endif.if:
  %.584 = icmp sgt i32 %.576, 0
  %.577 = load ptr, ptr %excinfo.7, align 8
  %.585 = select i1 %.584, ptr %.577, ptr undef
  store ptr %.585, ptr %excinfo, align 8
  br label %common.ret

B464.endif.endif.endif:
  %.idx = shl i64 %.111.0126, 6
  %3 = getelementptr i8, ptr %arg.method, i64 %.idx
  %.601 = getelementptr i8, ptr %3, i64 512
  store ptr null, ptr %.609, align 8
  %.613 = call i32 @combine.31(ptr nonnull %.609, ptr nonnull %excinfo.8, i64 %.84, i64 %.111.0126, ptr %.601, double %arg.h, ptr %arg.mass, ptr %arg.stages, ptr %arg.right, ptr %arg.after)
  switch i32 %.613, label %B464.endif.endif.endif.if [
    i32 -2, label %B464.endif.endif.endif.endif
    i32 0, label %B464.endif.endif.endif.endif
  ]

B464.endif.endif.endif.if:
  %.621 = icmp sgt i32 %.613, 0
  %.614 = load ptr, ptr %excinfo.8, align 8
  %.622 = select i1 %.621, ptr %.614, ptr undef
  store ptr %.622, ptr %excinfo, align 8
  br label %common.ret

B464.endif.endif.endif.endif:
  %.636 = getelementptr i8, ptr %2, i64 1088
  %.637 = load double, ptr %.636, align 8
  %.639 = fmul contract double %arg.h, %.637
  %.644 = fcmp contract une double %.639, 0.000000e+00
  br i1 %.644, label %B810, label %B846

B810.if:
  %.663 = icmp sgt i32 %.655, 0
  %.656 = load ptr, ptr %excinfo.9, align 8
  %.664 = select i1 %.663, ptr %.656, ptr undef
  store ptr %.664, ptr %excinfo, align 8
  br label %common.ret

B846.if:
  %.709 = icmp sgt i32 %.701, 0
  %.702 = load ptr, ptr %excinfo.10, align 8
  %.710 = select i1 %.709, ptr %.702, ptr undef
  store ptr %.710, ptr %excinfo, align 8
  br label %common.ret

B846.endif:
  %exitcond149.not = icmp eq i64 %.183, 8
  br i1 %exitcond149.not, label %B936, label %B72.if
}

define i64 @forward(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, i64 %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, ptr %a14, i64 %a15, ptr %a16, ptr %a17, ptr %a18, ptr %a19, ptr %a20, ptr %a21, i64 %a22, ptr %a23, i64 %a24, i64 %a25, ptr %a26, ptr %a27, ptr %a28, i64 %a29, ptr %a30, i64 %a31, ptr %a32, ptr %a33, ptr %a34) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @forward.58(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, i64 %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, ptr %a14, i64 %a15, ptr %a16, ptr %a17, ptr %a18, ptr %a19, ptr %a20, ptr %a21, i64 %a22, ptr %a23, i64 %a24, i64 %a25, ptr %a26, ptr %a27, ptr %a28, i64 %a29, ptr %a30, i64 %a31, ptr %a32, ptr %a33, ptr %a34)
  ret i64 0
}

define internal i32 @forward.58(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.pos, ptr noalias %arg.numbers, ptr noalias %arg.drive_rows, ptr noalias %arg.drive_columns, i64 %arg.blocks, ptr noalias %arg.own, ptr noalias %arg.slots, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, i64 %arg.entry_count, ptr noalias %arg.entry_rows, ptr noalias %arg.entry_columns, ptr noalias %arg.entry_places, ptr noalias %arg.mass, ptr noalias %arg.method, ptr noalias %arg.record, i64 %arg.step_count, ptr noalias %arg.edges, i64 %arg.edge_count, i64 %arg.directions, ptr noalias %arg.Y, ptr noalias %arg.y_dot, ptr noalias %arg.Y_dot, i64 %arg.Y_length, ptr noalias %arg.numbers_dot, i64 %arg.numbers_length, ptr noalias %arg.ends_dot, ptr noalias %arg.outputs, ptr noalias %arg.work) noinline {
entry:
  %.240 = alloca i64, align 8
  store i64 0, ptr %.240, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.444 = alloca i64, align 8
  store i64 0, ptr %.444, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.472 = alloca ptr, align 8
  store ptr null, ptr %.472, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.683 = alloca ptr, align 8
  store ptr null, ptr %.683, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.723 = alloca ptr, align 8
  store ptr null, ptr %.723, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.761 = alloca ptr, align 8
  store ptr null, ptr %.761, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.1188 = alloca double, align 8
  store double 0.000000e+00, ptr %.1188, align 8
  %excinfo.7 = alloca ptr, align 8
  store ptr null, ptr %excinfo.7, align 8
  %.1230 = alloca ptr, align 8
  store ptr null, ptr %.1230, align 8
  %excinfo.8 = alloca ptr, align 8
  store ptr null, ptr %excinfo.8, align 8
  %.1266 = alloca ptr, align 8
  store ptr null, ptr %.1266, align 8
  %excinfo.9 = alloca ptr, align 8
  store ptr null, ptr %excinfo.9, align 8
  %.1302 = alloca ptr, align 8
  store ptr null, ptr %.1302, align 8
  %excinfo.10 = alloca ptr, align 8
  store ptr null, ptr %excinfo.10, align 8
  %.1784 = alloca ptr, align 8
  store ptr null, ptr %.1784, align 8
  %excinfo.11 = alloca ptr, align 8
  store ptr null, ptr %excinfo.11, align 8
  %.1830 = alloca ptr, align 8
  store ptr null, ptr %.1830, align 8
  %excinfo.12 = alloca ptr, align 8
  store ptr null, ptr %excinfo.12, align 8
  %.1864 = alloca ptr, align 8
  store ptr null, ptr %.1864, align 8
  %excinfo.13 = alloca ptr, align 8
  store ptr null, ptr %excinfo.13, align 8
  %.2152 = alloca ptr, align 8
  store ptr null, ptr %.2152, align 8
  %excinfo.14 = alloca ptr, align 8
  store ptr null, ptr %excinfo.14, align 8
  %.2186 = alloca ptr, align 8
  store ptr null, ptr %.2186, align 8
  %excinfo.15 = alloca ptr, align 8
  store ptr null, ptr %excinfo.15, align 8
  %.2215 = alloca ptr, align 8
  store ptr null, ptr %.2215, align 8
  %excinfo.16 = alloca ptr, align 8
  store ptr null, ptr %excinfo.16, align 8
  %.2506 = alloca ptr, align 8
  store ptr null, ptr %.2506, align 8
  %excinfo.17 = alloca ptr, align 8
  store ptr null, ptr %excinfo.17, align 8
  %.2546 = alloca ptr, align 8
  store ptr null, ptr %.2546, align 8
  %excinfo.18 = alloca ptr, align 8
  store ptr null, ptr %excinfo.18, align 8
  %.2720 = alloca double, align 8
  store double 0.000000e+00, ptr %.2720, align 8
  %excinfo.19 = alloca ptr, align 8
  store ptr null, ptr %excinfo.19, align 8
  %.2749 = alloca double, align 8
  store double 0.000000e+00, ptr %.2749, align 8
  %excinfo.20 = alloca ptr, align 8
  store ptr null, ptr %excinfo.20, align 8
  %.2799 = alloca ptr, align 8
  store ptr null, ptr %.2799, align 8
  %excinfo.21 = alloca ptr, align 8
  store ptr null, ptr %excinfo.21, align 8
  %.2964 = alloca i64, align 8
  store i64 0, ptr %.2964, align 8
  %excinfo.22 = alloca ptr, align 8
  store ptr null, ptr %excinfo.22, align 8
  %.3004 = alloca ptr, align 8
  store ptr null, ptr %.3004, align 8
  %excinfo.23 = alloca ptr, align 8
  store ptr null, ptr %excinfo.23, align 8
  %.3207 = alloca ptr, align 8
  store ptr null, ptr %.3207, align 8
  %excinfo.24 = alloca ptr, align 8
  store ptr null, ptr %excinfo.24, align 8
  %.3372 = alloca ptr, align 8
  store ptr null, ptr %.3372, align 8
  %excinfo.25 = alloca ptr, align 8
  store ptr null, ptr %excinfo.25, align 8
  %.3419 = alloca ptr, align 8
  store ptr null, ptr %.3419, align 8
  %excinfo.26 = alloca ptr, align 8
  store ptr null, ptr %excinfo.26, align 8
  %.3539 = alloca ptr, align 8
  store ptr null, ptr %.3539, align 8
  %excinfo.27 = alloca ptr, align 8
  store ptr null, ptr %excinfo.27, align 8
  %.3694 = alloca double, align 8
  store double 0.000000e+00, ptr %.3694, align 8
  %excinfo.28 = alloca ptr, align 8
  store ptr null, ptr %excinfo.28, align 8
  %.3732 = alloca ptr, align 8
  store ptr null, ptr %.3732, align 8
  %excinfo.29 = alloca ptr, align 8
  store ptr null, ptr %excinfo.29, align 8
  %.4016 = alloca double, align 8
  store double 0.000000e+00, ptr %.4016, align 8
  %excinfo.30 = alloca ptr, align 8
  store ptr null, ptr %excinfo.30, align 8
  %.4049 = alloca ptr, align 8
  store ptr null, ptr %.4049, align 8
  %excinfo.31 = alloca ptr, align 8
  store ptr null, ptr %excinfo.31, align 8
  %.4205 = alloca double, align 8
  store double 0.000000e+00, ptr %.4205, align 8
  %excinfo.32 = alloca ptr, align 8
  store ptr null, ptr %excinfo.32, align 8
  %.4232 = alloca double, align 8
  store double 0.000000e+00, ptr %.4232, align 8
  %excinfo.33 = alloca ptr, align 8
  store ptr null, ptr %excinfo.33, align 8
  %.4451 = alloca ptr, align 8
  store ptr null, ptr %.4451, align 8
  %excinfo.34 = alloca ptr, align 8
  store ptr null, ptr %excinfo.34, align 8
  %.109 = load i64, ptr %arg.layout, align 8
  %.111 = getelementptr i8, ptr %arg.layout, i64 16
  %.112 = load i64, ptr %.111, align 8
  %.120 = getelementptr i8, ptr %arg.layout, i64 8
  %.121 = load i64, ptr %.120, align 8
  %.123 = add nsw i64 %.121, %.109
  %.125 = getelementptr i8, ptr %arg.layout, i64 24
  %.126 = load i64, ptr %.125, align 8
  %.134 = add nsw i64 %.112, 1
  %.136 = add nsw i64 %.126, %.134
  %.139 = shl nsw i64 %.109, 3
  %.140 = getelementptr double, ptr %arg.work, i64 %.139
  %.149.idx = mul i64 %.109, 136
  %.149 = getelementptr i8, ptr %arg.work, i64 %.149.idx
  %.idx = mul i64 %.109, 144
  %0 = getelementptr i8, ptr %arg.work, i64 %.idx
  %.153 = getelementptr i8, ptr %0, i64 8
  %.idx902 = mul i64 %.109, 152
  %1 = getelementptr i8, ptr %arg.work, i64 %.idx902
  %.157 = getelementptr i8, ptr %1, i64 8
  %.idx903 = mul i64 %.109, 160
  %2 = getelementptr i8, ptr %arg.work, i64 %.idx903
  %.170 = getelementptr i8, ptr %2, i64 8
  %.177.idx = shl i64 %arg.blocks, 5
  %.177 = getelementptr i8, ptr %.170, i64 %.177.idx
  %.184.idx = shl i64 %arg.blocks, 4
  %.184 = getelementptr i8, ptr %.177, i64 %.184.idx
  %.190 = getelementptr double, ptr %.184, i64 %.112
  %.195 = getelementptr double, ptr %.190, i64 %.136
  %.200 = getelementptr double, ptr %.195, i64 %.136
  %.207 = add nsw i64 %.121, 1
  %.209 = getelementptr double, ptr %.200, i64 %.207
  %.218 = getelementptr double, ptr %.209, i64 %.207
  %.223 = getelementptr i8, ptr %arg.layout, i64 56
  %.224 = load i64, ptr %.223, align 8
  %.226 = getelementptr double, ptr %.218, i64 %.224
  %.234 = getelementptr double, ptr %.226, i64 %.224
  store i64 0, ptr %.240, align 8
  %.244 = call i32 @moving_groups.59(ptr nonnull %.240, ptr nonnull %excinfo.1, ptr nonnull %arg.layout)
  switch i32 %.244, label %B0.if [
    i32 -2, label %B0.endif
    i32 0, label %B0.endif
  ]

B1370:
  %.5851187 = icmp sgt i64 %arg.step_count, 0
  br i1 %.5851187, label %B1408.lr.ph, label %B5720

B1408.lr.ph:
  %.531.11190 = add nsw i64 %arg.step_count, -1
  %.627 = add nsw i64 %.109, 3
  %.708 = getelementptr i8, ptr %arg.method, i64 1344
  %.750 = getelementptr double, ptr %arg.Y, i64 %.123
  %.824 = icmp sgt i64 %.109, 0
  %storemerge906 = select i1 %.824, i64 %.139, i64 0
  %.8661122 = icmp sgt i64 %storemerge906, 0
  %.9931138.not = icmp slt i64 %arg.directions, 1
  %storemerge924 = call i64 @llvm.smax.i64(i64 %.109, i64 0)
  %.14101130.not = icmp slt i64 %arg.entry_count, 1
  %.15461135.not = icmp slt i64 %.126, 1
  %.19681141.not = icmp slt i64 %.109, 1
  %.23201147 = icmp sgt i64 %storemerge906, 0
  %.2492 = shl i64 %.109, 6
  %.26561163.not = icmp slt i64 %arg.directions, 1
  %.31131160.not = icmp slt i64 %.109, 1
  %.33131166.not = icmp slt i64 %.126, 1
  %3 = getelementptr double, ptr %.190, i64 %.134
  %.3537.idx = mul i64 %.109, 448
  %.3537 = getelementptr i8, ptr %.269, i64 %.3537.idx
  %.3725 = getelementptr double, ptr %.140, i64 %.139
  %.38371171 = icmp sgt i64 %storemerge906, 0
  %.4044 = shl i64 %.109, 6
  %.41581181.not = icmp slt i64 %arg.directions, 1
  %.43601178.not = icmp slt i64 %.109, 1
  %4 = mul i64 %.254, %arg.directions
  %5 = shl i64 %4, 3
  %6 = mul i64 %.109, 800
  %7 = mul i64 %arg.blocks, 48
  %8 = mul i64 %.112, 24
  %9 = add i64 %.126, %.121
  %10 = add i64 %9, %.224
  %11 = shl i64 %10, 4
  %12 = getelementptr i8, ptr %arg.work, i64 %5
  %13 = getelementptr i8, ptr %12, i64 %6
  %14 = getelementptr i8, ptr %13, i64 %7
  %15 = getelementptr i8, ptr %14, i64 %8
  %16 = getelementptr i8, ptr %15, i64 %11
  %scevgep = getelementptr i8, ptr %16, i64 40
  %17 = shl nuw i64 %storemerge906, 3
  %18 = shl nuw i64 %storemerge924, 3
  %19 = add i64 %arg.edge_count, -1
  br label %B1408

B1408:
  %.575.sroa.0.01194 = phi i64 [ 0, %B1408.lr.ph ], [ %.575.sroa.0.0, %B5662.endif ]
  %.531.11193 = phi i64 [ %.531.11190, %B1408.lr.ph ], [ %.531.1, %B5662.endif ]
  %.528.11192 = phi i64 [ 1, %B1408.lr.ph ], [ %.528.1, %B5662.endif ]
  %start.2.01191 = phi i64 [ 0, %B1408.lr.ph ], [ %stop.3.2, %B5662.endif ]
  %.629 = mul nsw i64 %.575.sroa.0.01194, %.627
  %.631 = getelementptr double, ptr %arg.record, i64 %.629
  %.637 = load double, ptr %.631, align 8
  %.639 = getelementptr i8, ptr %.631, i64 8
  %.640 = load double, ptr %.639, align 8
  %.642 = getelementptr i8, ptr %.631, i64 24
  store ptr null, ptr %.683, align 8
  %.687 = call i32 @replay.48(ptr nonnull %.683, ptr nonnull %excinfo.4, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.pos, ptr %arg.numbers, ptr %arg.drive_rows, ptr %arg.drive_columns, i64 %arg.blocks, ptr %arg.own, ptr %arg.slots, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %arg.mass, ptr %arg.method, ptr nonnull %.631, ptr %arg.Y, ptr %arg.work, ptr %.140, ptr %.190, ptr %.200, ptr %.157, ptr %.184, ptr %.149, ptr %.153, ptr %.170, ptr %.177, ptr %.218, ptr %.226)
  switch i32 %.687, label %B1408.if [
    i32 -2, label %B1408.endif
    i32 0, label %B1408.endif
  ]

B1844.preheader:
  br i1 %.9931138.not, label %B2614.if.preheader, label %B1846.if

B2614.if.preheader:
  br label %B2614.if

B1844.loopexit:
  %exitcond1419.not = icmp eq i64 %arg.directions, %.1006
  br i1 %exitcond1419.not, label %B2614.if.preheader, label %B1846.if

B2006:
  %.1186.idx = shl i64 %.936.01139, 4
  %.1186 = getelementptr i8, ptr %arg.ends_dot, i64 %.1186.idx
  store double 0.000000e+00, ptr %.1188, align 8
  %.1192 = call i32 @begin_rate.60(ptr nonnull %.1188, ptr nonnull %excinfo.7, i64 %.575.sroa.0.01194, ptr %.1186)
  switch i32 %.1192, label %B2006.if [
    i32 -2, label %B2006.endif
    i32 0, label %B2006.endif
  ]

B2352:
  %invariant.gep1133 = getelementptr double, ptr %.288, i64 %.936.01139
  br i1 %.15461135.not, label %B1844.loopexit, label %B2382.if

B2942:
  %.20941144.not = icmp eq i64 %.1662.01169, 0
  br i1 %.20941144.not, label %B3096, label %B2972.if.lr.ph

B2972.if.lr.ph:
  %.idx923 = shl i64 %.1662.01169, 6
  %20 = getelementptr i8, ptr %arg.method, i64 %.idx923
  %21 = getelementptr i8, ptr %20, i64 512
  br label %B2972.if

B3096:
  store ptr null, ptr %.2186, align 8
  %.2190 = call i32 @add_scaled.29(ptr nonnull %.2186, ptr nonnull %excinfo.15, i64 %.109, double %.715, ptr %.1764, ptr %.153)
  switch i32 %.2190, label %B3096.if [
    i32 -2, label %B3096.endif
    i32 0, label %B3096.endif
  ]

B3298.preheader:
  %.24531150.not = icmp eq i64 %.1662.01169, 0
  br i1 %.24531150.not, label %B3548.preheader, label %B3298.if.lr.ph

B3298.if.lr.ph:
  %.idx930 = shl i64 %.1662.01169, 6
  %22 = getelementptr i8, ptr %arg.method, i64 %.idx930
  %23 = getelementptr i8, ptr %22, i64 512
  br label %B3298.if

B3548.preheader:
  br i1 %.26561163.not, label %B4282, label %B3550.if

B3968:
  store i64 0, ptr %.2964, align 8
  %.2968 = call i32 @moving_groups.59(ptr nonnull %.2964, ptr nonnull %excinfo.22, ptr nonnull %arg.layout)
  switch i32 %.2968, label %B3968.if [
    i32 -2, label %B3968.endif
    i32 0, label %B3968.endif
  ]

B4278:
  %exitcond1425.not = icmp eq i64 %arg.directions, %.2669
  br i1 %exitcond1425.not, label %B4282, label %B3550.if

B4282:
  store ptr null, ptr %.3207, align 8
  %.3211 = call i32 @multiply_sides.61(ptr nonnull %.3207, ptr nonnull %excinfo.24, i64 %arg.entry_count, ptr %arg.entry_rows, ptr %arg.entry_columns, ptr %arg.entry_places, ptr %.190, ptr %.308, ptr %.1764, ptr %.274, ptr %.284)
  switch i32 %.3211, label %B4282.if [
    i32 -2, label %B4282.endif
    i32 0, label %B4282.endif
  ]

B4546:
  %.3409.idx = shl i64 %.1762, 6
  %.3409 = getelementptr i8, ptr %.269, i64 %.3409.idx
  store ptr null, ptr %.3419, align 8
  %.3423 = call i32 @lu_solve_sides.36(ptr nonnull %.3419, ptr nonnull %excinfo.26, i64 %.109, ptr %arg.slots, i64 %arg.blocks, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %.184, ptr %.284, ptr %.3409, ptr %.315)
  switch i32 %.3423, label %B4546.if [
    i32 -2, label %B4546.endif
    i32 0, label %B4546.endif
  ]

B4648:
  %.3462 = icmp slt i64 %start.2.01191, %arg.edge_count
  br i1 %.3462, label %B4664, label %B4770

B4664:
  %.3473 = getelementptr double, ptr %arg.edges, i64 %start.2.01191
  %.3474 = load double, ptr %.3473, align 8
  %.3478 = getelementptr i8, ptr %.631, i64 16
  %.3479 = load double, ptr %.3478, align 8
  %.3480 = fmul contract double %.3479, 0x3FF0000000000005
  %.3481 = fcmp contract ugt double %.3474, %.3480
  br i1 %.3481, label %B4770, label %B4706

B4706:
  %stop.2.1 = phi i64 [ %.3487, %B4728 ], [ %start.2.01191, %B4664 ]
  %exitcond1428.not = icmp eq i64 %stop.2.1, %19
  br i1 %exitcond1428.not, label %B4770, label %B4728

B4728:
  %.3487 = add nsw i64 %stop.2.1, 1
  %.3508 = getelementptr double, ptr %arg.edges, i64 %.3487
  %.3509 = load double, ptr %.3508, align 8
  %.3516 = fcmp contract ugt double %.3509, %.3480
  br i1 %.3516, label %B4770, label %B4706

B4770:
  %stop.3.2 = phi i64 [ %start.2.01191, %B4664 ], [ %start.2.01191, %B4648 ], [ %arg.edge_count, %B4706 ], [ %.3487, %B4728 ]
  store ptr null, ptr %.3539, align 8
  %.3543 = call i32 @add_scaled.29(ptr nonnull %.3539, ptr nonnull %excinfo.27, i64 %.139, double 1.000000e+00, ptr %.3537, ptr %.274)
  switch i32 %.3543, label %B4770.if [
    i32 -2, label %B4770.endif
    i32 0, label %B4770.endif
  ]

B4920.loopexit:
  %.3647 = icmp sgt i64 %.3593.01186, 1
  br i1 %.3647, label %B4922.if, label %B5662

B5378.preheader:
  br i1 %.41581181.not, label %B4920.loopexit, label %B5378.if

B5378.loopexit:
  %exitcond1432.not = icmp eq i64 %arg.directions, %.4171
  br i1 %exitcond1432.not, label %B4920.loopexit, label %B5378.if

B5662:
  store ptr null, ptr %.4451, align 8
  %.4455 = call i32 @copy.27(ptr nonnull %.4451, ptr nonnull %excinfo.34, i64 %.139, ptr %.274, ptr %arg.y_dot)
  switch i32 %.4455, label %B5662.if [
    i32 -2, label %B5662.endif
    i32 0, label %B5662.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ 0, %B5720 ], [ %.4236, %B5380.endif.if ], [ %.4455, %B5662.if ], [ %.244, %B0.if ], [ %.448, %B1238.if ], [ %.3376, %B4360.if ], [ %.476, %B1238.endif.if ], [ %.687, %B1408.if ], [ %.727, %B1408.endif.endif.if ], [ %.4209, %B5380.if ], [ %.4053, %B5208.endif.if ], [ %.2803, %B3552.endif.endif.if ], [ %.765, %B1408.endif.endif.endif.if ], [ %.1192, %B2006.if ], [ %.1234, %B2006.endif.if ], [ %.1270, %B2006.endif.endif.if ], [ %.4020, %B5208.if ], [ %.3736, %B4924.endif.if ], [ %.2968, %B3968.if ], [ %.1306, %B2006.endif.endif.endif.if ], [ %.1788, %B2616.if ], [ %.1834, %B2616.endif.if ], [ %.3211, %B4282.if ], [ %.3698, %B4924.if ], [ %.1868, %B2616.endif.endif.if ], [ %.2156, %B2974.endif.if ], [ %.2190, %B3096.if ], [ %.3543, %B4770.if ], [ %.3008, %B3968.endif.if ], [ %.2219, %B3096.endif.if ], [ %.2510, %B3300.if ], [ %.3423, %B4546.if ], [ %.2550, %B3300.endif.endif.if ], [ %.2724, %B3552.if ], [ %.2753, %B3552.endif.if ]
  ret i32 %common.ret.op

B5720:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B0.if:
  %.252 = icmp sgt i32 %.244, 0
  %.245 = load ptr, ptr %excinfo.1, align 8
  %.253 = select i1 %.252, ptr %.245, ptr undef
  store ptr %.253, ptr %excinfo, align 8
  br label %common.ret

B0.endif:
  %.254 = load i64, ptr %.240, align 8
  %.267 = mul nsw i64 %.254, %arg.directions
  %.269 = getelementptr double, ptr %.234, i64 %.267
  %.274.idx = shl i64 %.109, 9
  %.274 = getelementptr i8, ptr %.269, i64 %.274.idx
  %.284.idx = mul i64 %.109, 576
  %.284 = getelementptr i8, ptr %.269, i64 %.284.idx
  %.288.idx = mul i64 %.109, 640
  %.288 = getelementptr i8, ptr %.269, i64 %.288.idx
  %.298.idx = mul i64 %.109, 704
  %.298 = getelementptr i8, ptr %.269, i64 %.298.idx
  %.304 = load i64, ptr %.120, align 8
  %.idx904 = shl i64 %.304, 6
  %24 = getelementptr i8, ptr %.298, i64 %.idx904
  %.308 = getelementptr i8, ptr %24, i64 64
  %.315.idx = shl i64 %arg.entry_count, 6
  %.315 = getelementptr i8, ptr %.308, i64 %.315.idx
  %.3991119.not = icmp slt i64 %arg.directions, 1
  br i1 %.3991119.not, label %B1370, label %B1236.if

B1236.if:
  %.343.01120 = phi i64 [ %.412, %B1238.endif.endif ], [ 0, %B0.endif ]
  %.412 = add nuw nsw i64 %.343.01120, 1
  store i64 0, ptr %.444, align 8
  %.448 = call i32 @moving_groups.59(ptr nonnull %.444, ptr nonnull %excinfo.2, ptr nonnull %arg.layout)
  switch i32 %.448, label %B1238.if [
    i32 -2, label %B1238.endif
    i32 0, label %B1238.endif
  ]

B1238.if:
  %.456 = icmp sgt i32 %.448, 0
  %.449 = load ptr, ptr %excinfo.2, align 8
  %.457 = select i1 %.456, ptr %.449, ptr undef
  store ptr %.457, ptr %excinfo, align 8
  br label %common.ret

B1238.endif:
  %.458 = load i64, ptr %.444, align 8
  %.439 = mul nsw i64 %.343.01120, %arg.numbers_length
  %.441 = getelementptr double, ptr %arg.numbers_dot, i64 %.439
  %.468 = mul nsw i64 %.458, %.343.01120
  %.470 = getelementptr double, ptr %.234, i64 %.468
  store ptr null, ptr %.472, align 8
  %.476 = call i32 @mark_moving.62(ptr nonnull %.472, ptr nonnull %excinfo.3, ptr nonnull %arg.layout, ptr %.441, ptr %.470)
  switch i32 %.476, label %B1238.endif.if [
    i32 -2, label %B1238.endif.endif
    i32 0, label %B1238.endif.endif
  ]

B1238.endif.if:
  %.484 = icmp sgt i32 %.476, 0
  %.477 = load ptr, ptr %excinfo.3, align 8
  %.485 = select i1 %.484, ptr %.477, ptr undef
  store ptr %.485, ptr %excinfo, align 8
  br label %common.ret

B1238.endif.endif:
  %exitcond.not = icmp eq i64 %arg.directions, %.412
  br i1 %exitcond.not, label %B1370, label %B1236.if

B1408.if:
  %.695 = icmp sgt i32 %.687, 0
  %.688 = load ptr, ptr %excinfo.4, align 8
  %.696 = select i1 %.695, ptr %.688, ptr undef
  store ptr %.696, ptr %excinfo, align 8
  br label %common.ret

B1408.endif:
  %.709 = load double, ptr %.708, align 8
  %.711 = fmul contract double %.640, %.709
  %.715 = fdiv contract double 1.000000e+00, %.711
  store ptr null, ptr %.723, align 8
  %.727 = call i32 @copy.27(ptr nonnull %.723, ptr nonnull %excinfo.5, i64 %.109, ptr %.642, ptr %arg.Y)
  switch i32 %.727, label %B1408.endif.endif.if [
    i32 -2, label %B1408.endif.endif.endif
    i32 0, label %B1408.endif.endif.endif
  ]

B1408.endif.endif.if:
  %.735 = icmp sgt i32 %.727, 0
  %.728 = load ptr, ptr %excinfo.5, align 8
  %.736 = select i1 %.735, ptr %.728, ptr undef
  store ptr %.736, ptr %excinfo, align 8
  br label %common.ret

B1408.endif.endif.endif:
  store double %.637, ptr %.750, align 8
  store ptr null, ptr %.761, align 8
  %.765 = call i32 @drive.6(ptr nonnull %.761, ptr nonnull %excinfo.6, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.218, ptr %.226)
  switch i32 %.765, label %B1408.endif.endif.endif.if [
    i32 -2, label %B1408.endif.endif.endif.endif
    i32 0, label %B1408.endif.endif.endif.endif
  ]

B1408.endif.endif.endif.if:
  %.773 = icmp sgt i32 %.765, 0
  %.766 = load ptr, ptr %excinfo.6, align 8
  %.774 = select i1 %.773, ptr %.766, ptr undef
  store ptr %.774, ptr %excinfo, align 8
  br label %common.ret

B1408.endif.endif.endif.endif:
  br i1 %.8661122, label %B1798.if.preheader, label %B1844.preheader

B1798.if.preheader:
  call void @llvm.memset.p0.i64(ptr align 8 %scevgep, i8 0, i64 %17, i1 false)
  br label %B1844.preheader

B1846.if:
  %.936.01139 = phi i64 [ %.1006, %B1844.loopexit ], [ 0, %B1844.preheader ]
  %.1006 = add nuw nsw i64 %.936.01139, 1
  %.1036 = mul nsw i64 %.936.01139, %arg.Y_length
  %.1038 = getelementptr double, ptr %arg.Y_dot, i64 %.1036
  %.1041 = mul nsw i64 %.936.01139, %arg.numbers_length
  %.1043 = getelementptr double, ptr %arg.numbers_dot, i64 %.1041
  %invariant.gep = getelementptr double, ptr %arg.y_dot, i64 %.936.01139
  br i1 %.824, label %B1956.if, label %B2006

B1956.if:
  %.1074.01126 = phi i64 [ %.1143, %B1956.if ], [ 0, %B1846.if ]
  %.1143 = add nuw nsw i64 %.1074.01126, 1
  %.idx929 = shl i64 %.1074.01126, 6
  %gep = getelementptr i8, ptr %invariant.gep, i64 %.idx929
  %.1173 = load double, ptr %gep, align 8
  %.1175 = getelementptr double, ptr %.1038, i64 %.1074.01126
  store double %.1173, ptr %.1175, align 8
  %exitcond1416.not = icmp eq i64 %.109, %.1143
  br i1 %exitcond1416.not, label %B2006, label %B1956.if

B2006.if:
  %.1200 = icmp sgt i32 %.1192, 0
  %.1193 = load ptr, ptr %excinfo.7, align 8
  %.1201 = select i1 %.1200, ptr %.1193, ptr undef
  store ptr %.1201, ptr %excinfo, align 8
  br label %common.ret

B2006.endif:
  %.1202 = load double, ptr %.1188, align 8
  %.1214 = getelementptr double, ptr %.1038, i64 %.123
  store double %.1202, ptr %.1214, align 8
  %.1219 = getelementptr double, ptr %.1038, i64 %.109
  store ptr null, ptr %.1230, align 8
  %.1234 = call i32 @push_drive.44(ptr nonnull %.1230, ptr nonnull %excinfo.8, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, i64 0, ptr %.1038, ptr %.1043, ptr %.1219, ptr %.218, ptr %.226)
  switch i32 %.1234, label %B2006.endif.if [
    i32 -2, label %B2006.endif.endif
    i32 0, label %B2006.endif.endif
  ]

B2006.endif.if:
  %.1242 = icmp sgt i32 %.1234, 0
  %.1235 = load ptr, ptr %excinfo.8, align 8
  %.1243 = select i1 %.1242, ptr %.1235, ptr undef
  store ptr %.1243, ptr %excinfo, align 8
  br label %common.ret

B2006.endif.endif:
  store ptr null, ptr %.1266, align 8
  %.1270 = call i32 @push_drive.63(ptr nonnull %.1266, ptr nonnull %excinfo.9, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, i64 1, ptr %.1038, ptr %.1043, ptr %.209, ptr %.218, ptr %.226)
  switch i32 %.1270, label %B2006.endif.endif.if [
    i32 -2, label %B2006.endif.endif.endif
    i32 0, label %B2006.endif.endif.endif
  ]

B2006.endif.endif.if:
  %.1278 = icmp sgt i32 %.1270, 0
  %.1271 = load ptr, ptr %excinfo.9, align 8
  %.1279 = select i1 %.1278, ptr %.1271, ptr undef
  store ptr %.1279, ptr %excinfo, align 8
  br label %common.ret

B2006.endif.endif.endif:
  store ptr null, ptr %.1302, align 8
  %.1306 = call i32 @push_jacobian.64(ptr nonnull %.1302, ptr nonnull %excinfo.10, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.pos, ptr %arg.numbers, ptr %arg.Y, ptr %.1038, ptr %.1043, ptr %.195, ptr %.218, ptr %.226)
  switch i32 %.1306, label %B2006.endif.endif.endif.if [
    i32 -2, label %B2006.endif.endif.endif.endif
    i32 0, label %B2006.endif.endif.endif.endif
  ]

B2006.endif.endif.endif.if:
  %.1314 = icmp sgt i32 %.1306, 0
  %.1307 = load ptr, ptr %excinfo.10, align 8
  %.1315 = select i1 %.1314, ptr %.1307, ptr undef
  store ptr %.1315, ptr %excinfo, align 8
  br label %common.ret

B2006.endif.endif.endif.endif:
  %invariant.gep1128 = getelementptr double, ptr %.308, i64 %.936.01139
  br i1 %.14101130.not, label %B2352, label %B2290.if

B2290.if:
  %.1354.01131 = phi i64 [ %.1423, %B2290.if ], [ 0, %B2006.endif.endif.endif.endif ]
  %.1423 = add nuw nsw i64 %.1354.01131, 1
  %.1449 = getelementptr i32, ptr %arg.entry_places, i64 %.1354.01131
  %.1450 = load i32, ptr %.1449, align 4
  %.1452 = sext i32 %.1450 to i64
  %.1453 = getelementptr double, ptr %.195, i64 %.1452
  %.1454 = load double, ptr %.1453, align 8
  %.idx928 = shl i64 %.1354.01131, 6
  %gep1129 = getelementptr i8, ptr %invariant.gep1128, i64 %.idx928
  store double %.1454, ptr %gep1129, align 8
  %exitcond1417.not = icmp eq i64 %arg.entry_count, %.1423
  br i1 %exitcond1417.not, label %B2352, label %B2290.if

B2382.if:
  %.1490.01136 = phi i64 [ %.1559, %B2382.if ], [ 0, %B2352 ]
  %.1559 = add nuw nsw i64 %.1490.01136, 1
  %.1585 = getelementptr i32, ptr %arg.drive_rows, i64 %.1490.01136
  %.1586 = load i32, ptr %.1585, align 4
  %.1587 = sext i32 %.1586 to i64
  %.idx927 = shl nsw i64 %.1587, 6
  %gep1134 = getelementptr i8, ptr %invariant.gep1133, i64 %.idx927
  %.1593 = load double, ptr %gep1134, align 8
  %.1596 = add nsw i64 %.1490.01136, %.134
  %.1598 = getelementptr double, ptr %.195, i64 %.1596
  %.1599 = load double, ptr %.1598, align 8
  %.1601 = getelementptr i32, ptr %arg.drive_columns, i64 %.1490.01136
  %.1602 = load i32, ptr %.1601, align 4
  %.1604 = sext i32 %.1602 to i64
  %.1605 = getelementptr double, ptr %.200, i64 %.1604
  %.1606 = load double, ptr %.1605, align 8
  %.1607 = fmul contract double %.1599, %.1606
  %.1612 = getelementptr double, ptr %.190, i64 %.1596
  %.1613 = load double, ptr %.1612, align 8
  %.1619 = getelementptr double, ptr %.209, i64 %.1604
  %.1620 = load double, ptr %.1619, align 8
  %.1621 = fmul contract double %.1613, %.1620
  %.1622 = fadd contract double %.1607, %.1621
  %.1623 = fadd contract double %.1593, %.1622
  store double %.1623, ptr %gep1134, align 8
  %exitcond1418.not = icmp eq i64 %.126, %.1559
  br i1 %exitcond1418.not, label %B1844.loopexit, label %B2382.if

B2614.if:
  %.1662.01169 = phi i64 [ %.1732, %B4546.endif ], [ 0, %B2614.if.preheader ]
  %.1732 = add nuw nsw i64 %.1662.01169, 1
  %.1762 = mul nsw i64 %.1662.01169, %.109
  %.1764 = getelementptr double, ptr %arg.work, i64 %.1762
  %25 = getelementptr double, ptr %arg.method, i64 %.1662.01169
  %.1768 = getelementptr i8, ptr %25, i64 1088
  %.1769 = load double, ptr %.1768, align 8
  %.1781 = getelementptr double, ptr %.140, i64 %.1762
  store ptr null, ptr %.1784, align 8
  %.1788 = call i32 @copy.27(ptr nonnull %.1784, ptr nonnull %excinfo.11, i64 %.109, ptr %.1781, ptr %arg.Y)
  switch i32 %.1788, label %B2616.if [
    i32 -2, label %B2616.endif
    i32 0, label %B2616.endif
  ]

B2616.if:
  %.1796 = icmp sgt i32 %.1788, 0
  %.1789 = load ptr, ptr %excinfo.11, align 8
  %.1797 = select i1 %.1796, ptr %.1789, ptr undef
  store ptr %.1797, ptr %excinfo, align 8
  br label %common.ret

B2616.endif:
  %.1811 = getelementptr i8, ptr %25, i64 1024
  %.1812 = load double, ptr %.1811, align 8
  %.1814 = fmul contract double %.640, %.1812
  %.1816 = fadd contract double %.637, %.1814
  store double %.1816, ptr %.750, align 8
  store ptr null, ptr %.1830, align 8
  %.1834 = call i32 @drive.6(ptr nonnull %.1830, ptr nonnull %excinfo.12, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.218, ptr %.226)
  switch i32 %.1834, label %B2616.endif.if [
    i32 -2, label %B2616.endif.endif
    i32 0, label %B2616.endif.endif
  ]

B2616.endif.if:
  %.1842 = icmp sgt i32 %.1834, 0
  %.1835 = load ptr, ptr %excinfo.12, align 8
  %.1843 = select i1 %.1842, ptr %.1835, ptr undef
  store ptr %.1843, ptr %excinfo, align 8
  br label %common.ret

B2616.endif.endif:
  store ptr null, ptr %.1864, align 8
  %.1868 = call i32 @jacobian.4(ptr nonnull %.1864, ptr nonnull %excinfo.13, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.pos, ptr %arg.numbers, ptr %arg.Y, ptr %.190, ptr %.218, ptr %.226)
  switch i32 %.1868, label %B2616.endif.endif.if [
    i32 -2, label %B2616.endif.endif.endif
    i32 0, label %B2616.endif.endif.endif
  ]

B2616.endif.endif.if:
  %.1876 = icmp sgt i32 %.1868, 0
  %.1869 = load ptr, ptr %excinfo.13, align 8
  %.1877 = select i1 %.1876, ptr %.1869, ptr undef
  store ptr %.1877, ptr %excinfo, align 8
  br label %common.ret

B2616.endif.endif.endif:
  br i1 %.19681141.not, label %B2942, label %B2926.if.preheader

B2926.if.preheader:
  call void @llvm.memset.p0.i64(ptr align 8 %.153, i8 0, i64 %18, i1 false)
  br label %B2942

B2972.if:
  %.2038.01145 = phi i64 [ 0, %B2972.if.lr.ph ], [ %.2107, %B2974.endif.endif ]
  %.2138 = getelementptr double, ptr %21, i64 %.2038.01145
  %.2139 = load double, ptr %.2138, align 8
  %.2140 = fneg contract double %.2139
  %.2145 = fdiv contract double %.2140, %.640
  %.2147 = mul nsw i64 %.2038.01145, %.109
  %.2149 = getelementptr double, ptr %arg.work, i64 %.2147
  store ptr null, ptr %.2152, align 8
  %.2156 = call i32 @add_scaled.29(ptr nonnull %.2152, ptr nonnull %excinfo.14, i64 %.109, double %.2145, ptr %.2149, ptr %.153)
  switch i32 %.2156, label %B2974.endif.if [
    i32 -2, label %B2974.endif.endif
    i32 0, label %B2974.endif.endif
  ]

B2974.endif.if:
  %.2164 = icmp sgt i32 %.2156, 0
  %.2157 = load ptr, ptr %excinfo.14, align 8
  %.2165 = select i1 %.2164, ptr %.2157, ptr undef
  store ptr %.2165, ptr %excinfo, align 8
  br label %common.ret

B2974.endif.endif:
  %.2107 = add nuw nsw i64 %.2038.01145, 1
  %exitcond1420.not = icmp eq i64 %.2107, %.1662.01169
  br i1 %exitcond1420.not, label %B3096, label %B2972.if

B3096.if:
  %.2198 = icmp sgt i32 %.2190, 0
  %.2191 = load ptr, ptr %excinfo.15, align 8
  %.2199 = select i1 %.2198, ptr %.2191, ptr undef
  store ptr %.2199, ptr %excinfo, align 8
  br label %common.ret

B3096.endif:
  store ptr null, ptr %.2215, align 8
  %.2219 = call i32 @copy.27(ptr nonnull %.2215, ptr nonnull %excinfo.16, i64 %.139, ptr %arg.y_dot, ptr %.274)
  switch i32 %.2219, label %B3096.endif.if [
    i32 -2, label %B3096.endif.endif
    i32 0, label %B3096.endif.endif
  ]

B3096.endif.if:
  %.2227 = icmp sgt i32 %.2219, 0
  %.2220 = load ptr, ptr %excinfo.16, align 8
  %.2228 = select i1 %.2227, ptr %.2220, ptr undef
  store ptr %.2228, ptr %excinfo, align 8
  br label %common.ret

B3096.endif.endif:
  br i1 %.23201147, label %B3228.if.lr.ph, label %B3298.preheader

B3228.if.lr.ph:
  %.2360 = fmul contract double %.640, %.1769
  br label %B3228.if

B3228.if:
  %.2264.01148 = phi i64 [ 0, %B3228.if.lr.ph ], [ %.2333, %B3228.if ]
  %.2333 = add nuw nsw i64 %.2264.01148, 1
  %.2362 = getelementptr double, ptr %.288, i64 %.2264.01148
  %.2363 = load double, ptr %.2362, align 8
  %.2364 = fmul contract double %.2360, %.2363
  %.2366 = getelementptr double, ptr %.284, i64 %.2264.01148
  store double %.2364, ptr %.2366, align 8
  %exitcond1421.not = icmp eq i64 %.2333, %storemerge906
  br i1 %exitcond1421.not, label %B3298.preheader, label %B3228.if

B3298.if:
  %.2397.01151 = phi i64 [ 0, %B3298.if.lr.ph ], [ %.2466, %B3300.endif.endif.endif ]
  %.2466 = add nuw nsw i64 %.2397.01151, 1
  %.2495.idx = mul i64 %.2492, %.2397.01151
  %.2495 = getelementptr i8, ptr %.269, i64 %.2495.idx
  %.2503 = getelementptr double, ptr %22, i64 %.2397.01151
  %.2504 = load double, ptr %.2503, align 8
  store ptr null, ptr %.2506, align 8
  %.2510 = call i32 @add_scaled.29(ptr nonnull %.2506, ptr nonnull %excinfo.17, i64 %.139, double %.2504, ptr %.2495, ptr %.274)
  switch i32 %.2510, label %B3300.if [
    i32 -2, label %B3300.endif
    i32 0, label %B3300.endif
  ]

B3300.if:
  %.2518 = icmp sgt i32 %.2510, 0
  %.2511 = load ptr, ptr %excinfo.17, align 8
  %.2519 = select i1 %.2518, ptr %.2511, ptr undef
  store ptr %.2519, ptr %excinfo, align 8
  br label %common.ret

B3300.endif:
  %.2536 = getelementptr double, ptr %23, i64 %.2397.01151
  %.2537 = load double, ptr %.2536, align 8
  %.2542 = fdiv contract double %.2537, %.640
  store ptr null, ptr %.2546, align 8
  %.2550 = call i32 @add_masses.65(ptr nonnull %.2546, ptr nonnull %excinfo.18, i64 %.109, ptr %arg.mass, double %.2542, ptr %.2495, ptr %.284)
  switch i32 %.2550, label %B3300.endif.endif.if [
    i32 -2, label %B3300.endif.endif.endif
    i32 0, label %B3300.endif.endif.endif
  ]

B3300.endif.endif.if:
  %.2558 = icmp sgt i32 %.2550, 0
  %.2551 = load ptr, ptr %excinfo.18, align 8
  %.2559 = select i1 %.2558, ptr %.2551, ptr undef
  store ptr %.2559, ptr %excinfo, align 8
  br label %common.ret

B3300.endif.endif.endif:
  %exitcond1422.not = icmp eq i64 %.2466, %.1662.01169
  br i1 %exitcond1422.not, label %B3548.preheader, label %B3298.if

B3550.if:
  %.2599.01164 = phi i64 [ %.2669, %B4278 ], [ 0, %B3548.preheader ]
  %.2669 = add nuw nsw i64 %.2599.01164, 1
  %.2699 = mul nsw i64 %.2599.01164, %arg.Y_length
  %.2701 = getelementptr double, ptr %arg.Y_dot, i64 %.2699
  %.2704 = mul nsw i64 %.2599.01164, %arg.numbers_length
  %.2706 = getelementptr double, ptr %arg.numbers_dot, i64 %.2704
  %.2716.idx = shl i64 %.2599.01164, 4
  %.2716 = getelementptr i8, ptr %arg.ends_dot, i64 %.2716.idx
  store double 0.000000e+00, ptr %.2720, align 8
  %.2724 = call i32 @size_rate.66(ptr nonnull %.2720, ptr nonnull %excinfo.19, i64 %.575.sroa.0.01194, i64 %arg.step_count, ptr %.2716)
  %.2734 = load double, ptr %.2720, align 8
  switch i32 %.2724, label %B3552.if [
    i32 -2, label %B3552.endif
    i32 0, label %B3552.endif
  ]

B3552.if:
  %.2732 = icmp sgt i32 %.2724, 0
  %.2725 = load ptr, ptr %excinfo.19, align 8
  %.2733 = select i1 %.2732, ptr %.2725, ptr undef
  store ptr %.2733, ptr %excinfo, align 8
  br label %common.ret

B3552.endif:
  store double 0.000000e+00, ptr %.2749, align 8
  %.2753 = call i32 @begin_rate.60(ptr nonnull %.2749, ptr nonnull %excinfo.20, i64 %.575.sroa.0.01194, ptr %.2716)
  switch i32 %.2753, label %B3552.endif.if [
    i32 -2, label %B3552.endif.endif
    i32 0, label %B3552.endif.endif
  ]

B3552.endif.if:
  %.2761 = icmp sgt i32 %.2753, 0
  %.2754 = load ptr, ptr %excinfo.20, align 8
  %.2762 = select i1 %.2761, ptr %.2754, ptr undef
  store ptr %.2762, ptr %excinfo, align 8
  br label %common.ret

B3552.endif.endif:
  %.2763 = load double, ptr %.2749, align 8
  %.2777 = load double, ptr %.1811, align 8
  %.2779 = fmul contract double %.2734, %.2777
  %.2780 = fadd contract double %.2763, %.2779
  %.2783 = getelementptr double, ptr %.2701, i64 %.123
  store double %.2780, ptr %.2783, align 8
  %.2788 = getelementptr double, ptr %.2701, i64 %.109
  store ptr null, ptr %.2799, align 8
  %.2803 = call i32 @push_drive.44(ptr nonnull %.2799, ptr nonnull %excinfo.21, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, i64 0, ptr %.2701, ptr %.2706, ptr %.2788, ptr %.218, ptr %.226)
  switch i32 %.2803, label %B3552.endif.endif.if [
    i32 -2, label %B3552.endif.endif.endif
    i32 0, label %B3552.endif.endif.endif
  ]

B3552.endif.endif.if:
  %.2811 = icmp sgt i32 %.2803, 0
  %.2804 = load ptr, ptr %excinfo.21, align 8
  %.2812 = select i1 %.2811, ptr %.2804, ptr undef
  store ptr %.2812, ptr %excinfo, align 8
  br label %common.ret

B3552.endif.endif.endif:
  %.2825 = load i64, ptr %.120, align 8
  %invariant.gep1153 = getelementptr double, ptr %.298, i64 %.2599.01164
  %.29051155.not = icmp slt i64 %.2825, 1
  br i1 %.29051155.not, label %B3968, label %B3912.if

B3912.if:
  %.2849.01156 = phi i64 [ %.2918, %B3912.if ], [ 0, %B3552.endif.endif.endif ]
  %.2918 = add nuw nsw i64 %.2849.01156, 1
  %.2946 = getelementptr double, ptr %.2788, i64 %.2849.01156
  %.2947 = load double, ptr %.2946, align 8
  %.idx922 = shl i64 %.2849.01156, 6
  %gep1154 = getelementptr i8, ptr %invariant.gep1153, i64 %.idx922
  store double %.2947, ptr %gep1154, align 8
  %exitcond1423.not = icmp eq i64 %.2825, %.2918
  br i1 %exitcond1423.not, label %B3968, label %B3912.if

B3968.if:
  %.2976 = icmp sgt i32 %.2968, 0
  %.2969 = load ptr, ptr %excinfo.22, align 8
  %.2977 = select i1 %.2976, ptr %.2969, ptr undef
  store ptr %.2977, ptr %excinfo, align 8
  br label %common.ret

B3968.endif:
  %.2978 = load i64, ptr %.2964, align 8
  %.2989 = mul nsw i64 %.2978, %.2599.01164
  %.2991 = getelementptr double, ptr %.234, i64 %.2989
  %.2994 = getelementptr double, ptr %.284, i64 %.2599.01164
  store ptr null, ptr %.3004, align 8
  %.3008 = call i32 @push_numbers.67(ptr nonnull %.3004, ptr nonnull %excinfo.23, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.2706, ptr %.2991, ptr %.2994, ptr %.218, ptr %.226)
  switch i32 %.3008, label %B3968.endif.if [
    i32 -2, label %B3968.endif.endif
    i32 0, label %B3968.endif.endif
  ]

B3968.endif.if:
  %.3016 = icmp sgt i32 %.3008, 0
  %.3009 = load ptr, ptr %excinfo.23, align 8
  %.3017 = select i1 %.3016, ptr %.3009, ptr undef
  store ptr %.3017, ptr %excinfo, align 8
  br label %common.ret

B3968.endif.endif:
  %.3031 = fcmp contract une double %.2734, 0.000000e+00
  br i1 %.3031, label %B4148.preheader, label %B4278

B4148.preheader:
  %invariant.gep1158 = getelementptr double, ptr %.284, i64 %.2599.01164
  br i1 %.31131160.not, label %B4278, label %B4148.if

B4148.if:
  %.3057.01161 = phi i64 [ %.3126, %B4148.if ], [ 0, %B4148.preheader ]
  %.3126 = add nuw nsw i64 %.3057.01161, 1
  %.3152 = getelementptr double, ptr %arg.mass, i64 %.3057.01161
  %.3153 = load double, ptr %.3152, align 8
  %.3158 = fdiv contract double %.3153, %.640
  %.3160 = getelementptr double, ptr %.153, i64 %.3057.01161
  %.3161 = load double, ptr %.3160, align 8
  %.3162 = fmul contract double %.3158, %.3161
  %.3164 = getelementptr double, ptr %.157, i64 %.3057.01161
  %.3165 = load double, ptr %.3164, align 8
  %.3167 = fmul contract double %.1769, %.3165
  %.3168 = fadd contract double %.3162, %.3167
  %.idx921 = shl i64 %.3057.01161, 6
  %gep1159 = getelementptr i8, ptr %invariant.gep1158, i64 %.idx921
  %.3174 = load double, ptr %gep1159, align 8
  %.3176 = fmul contract double %.2734, %.3168
  %.3177 = fadd contract double %.3174, %.3176
  store double %.3177, ptr %gep1159, align 8
  %exitcond1424.not = icmp eq i64 %.109, %.3126
  br i1 %exitcond1424.not, label %B4278, label %B4148.if

B4282.if:
  %.3219 = icmp sgt i32 %.3211, 0
  %.3212 = load ptr, ptr %excinfo.24, align 8
  %.3220 = select i1 %.3219, ptr %.3212, ptr undef
  store ptr %.3220, ptr %excinfo, align 8
  br label %common.ret

B4282.endif:
  br i1 %.33131166.not, label %B4546, label %B4358.if

B4358.if:
  %.3257.01167 = phi i64 [ %.3326, %B4360.endif ], [ 0, %B4282.endif ]
  %.3356 = getelementptr double, ptr %3, i64 %.3257.01167
  %.3357 = load double, ptr %.3356, align 8
  %.3359 = getelementptr i32, ptr %arg.drive_columns, i64 %.3257.01167
  %.3360 = load i32, ptr %.3359, align 4
  %.3361 = sext i32 %.3360 to i64
  %.3364.idx = shl nsw i64 %.3361, 6
  %.3364 = getelementptr i8, ptr %.298, i64 %.3364.idx
  %.3366 = getelementptr i32, ptr %arg.drive_rows, i64 %.3257.01167
  %.3367 = load i32, ptr %.3366, align 4
  %.3368 = sext i32 %.3367 to i64
  %.3371.idx = shl nsw i64 %.3368, 6
  %.3371 = getelementptr i8, ptr %.284, i64 %.3371.idx
  store ptr null, ptr %.3372, align 8
  %.3376 = call i32 @add_scaled.68(ptr nonnull %.3372, ptr nonnull %excinfo.25, i64 8, double %.3357, ptr %.3364, ptr %.3371)
  switch i32 %.3376, label %B4360.if [
    i32 -2, label %B4360.endif
    i32 0, label %B4360.endif
  ]

B4360.if:
  %.3384 = icmp sgt i32 %.3376, 0
  %.3377 = load ptr, ptr %excinfo.25, align 8
  %.3385 = select i1 %.3384, ptr %.3377, ptr undef
  store ptr %.3385, ptr %excinfo, align 8
  br label %common.ret

B4360.endif:
  %.3326 = add nuw nsw i64 %.3257.01167, 1
  %exitcond1426.not = icmp eq i64 %.126, %.3326
  br i1 %exitcond1426.not, label %B4546, label %B4358.if

B4546.if:
  %.3431 = icmp sgt i32 %.3423, 0
  %.3424 = load ptr, ptr %excinfo.26, align 8
  %.3432 = select i1 %.3431, ptr %.3424, ptr undef
  store ptr %.3432, ptr %excinfo, align 8
  br label %common.ret

B4546.endif:
  %exitcond1427.not = icmp eq i64 %.1732, 8
  br i1 %exitcond1427.not, label %B4648, label %B2614.if

B4770.if:
  %.3551 = icmp sgt i32 %.3543, 0
  %.3544 = load ptr, ptr %excinfo.27, align 8
  %.3552 = select i1 %.3551, ptr %.3544, ptr undef
  store ptr %.3552, ptr %excinfo, align 8
  br label %common.ret

B4770.endif:
  %.3603 = sub i64 %stop.3.2, %start.2.01191
  %.36471184.not = icmp slt i64 %.3603, 1
  br i1 %.36471184.not, label %B5662, label %B4922.if

B4922.if:
  %.3593.01186 = phi i64 [ %.3656, %B4920.loopexit ], [ %.3603, %B4770.endif ]
  %.3590.01185 = phi i64 [ %.3660, %B4920.loopexit ], [ %start.2.01191, %B4770.endif ]
  %.3656 = add nsw i64 %.3593.01186, -1
  %.3660 = add i64 %.3590.01185, 1
  %.3691 = getelementptr double, ptr %arg.edges, i64 %.3590.01185
  %.3692 = load double, ptr %.3691, align 8
  store double 0.000000e+00, ptr %.3694, align 8
  %.3698 = call i32 @part_done.53(ptr nonnull %.3694, ptr nonnull %excinfo.28, double %.3692, ptr nonnull %.631)
  %.3708 = load double, ptr %.3694, align 8
  switch i32 %.3698, label %B4924.if [
    i32 -2, label %B4924.endif
    i32 0, label %B4924.endif
  ]

B4924.if:
  %.3706 = icmp sgt i32 %.3698, 0
  %.3699 = load ptr, ptr %excinfo.28, align 8
  %.3707 = select i1 %.3706, ptr %.3699, ptr undef
  store ptr %.3707, ptr %excinfo, align 8
  br label %common.ret

B4924.endif:
  store ptr null, ptr %.3732, align 8
  %.3736 = call i32 @dense_rate.50(ptr nonnull %.3732, ptr nonnull %excinfo.29, i64 %.109, ptr %arg.method, double %.3708, ptr %.642, ptr %.3725, ptr %arg.work, ptr %.149)
  switch i32 %.3736, label %B4924.endif.if [
    i32 -2, label %B4924.endif.endif
    i32 0, label %B4924.endif.endif
  ]

B4924.endif.if:
  %.3744 = icmp sgt i32 %.3736, 0
  %.3737 = load ptr, ptr %excinfo.29, align 8
  %.3745 = select i1 %.3744, ptr %.3737, ptr undef
  store ptr %.3745, ptr %excinfo, align 8
  br label %common.ret

B4924.endif.endif:
  br i1 %.38371171, label %B5102.if.lr.ph, label %B5206.if.preheader

B5102.if.lr.ph:
  %.3877 = fsub contract double 1.000000e+00, %.3708
  br label %B5102.if

B5102.if:
  %.3781.01172 = phi i64 [ 0, %B5102.if.lr.ph ], [ %.3850, %B5102.if ]
  %.3850 = add nuw nsw i64 %.3781.01172, 1
  %.3879 = getelementptr double, ptr %arg.y_dot, i64 %.3781.01172
  %.3880 = load double, ptr %.3879, align 8
  %.3881 = fmul contract double %.3877, %.3880
  %.3883 = getelementptr double, ptr %.274, i64 %.3781.01172
  %.3884 = load double, ptr %.3883, align 8
  %.3886 = fmul contract double %.3708, %.3884
  %.3887 = fadd contract double %.3881, %.3886
  %.3889 = getelementptr double, ptr %.284, i64 %.3781.01172
  store double %.3887, ptr %.3889, align 8
  %exitcond1429.not = icmp eq i64 %.3850, %storemerge906
  br i1 %exitcond1429.not, label %B5206.if.preheader, label %B5102.if

B5206.if.preheader:
  br label %B5206.if

B5206.if:
  %.3919.01174 = phi i64 [ %.3988, %B5208.endif.endif ], [ 0, %B5206.if.preheader ]
  %.3988 = add nuw nsw i64 %.3919.01174, 1
  store double 0.000000e+00, ptr %.4016, align 8
  %.4020 = call i32 @dense_weight.54(ptr nonnull %.4016, ptr nonnull %excinfo.30, ptr %arg.method, i64 %.3919.01174, double %.3708)
  switch i32 %.4020, label %B5208.if [
    i32 -2, label %B5208.endif
    i32 0, label %B5208.endif
  ]

B5208.if:
  %.4028 = icmp sgt i32 %.4020, 0
  %.4021 = load ptr, ptr %excinfo.30, align 8
  %.4029 = select i1 %.4028, ptr %.4021, ptr undef
  store ptr %.4029, ptr %excinfo, align 8
  br label %common.ret

B5208.endif:
  %.4030 = load double, ptr %.4016, align 8
  %.4047.idx = mul i64 %.4044, %.3919.01174
  %.4047 = getelementptr i8, ptr %.269, i64 %.4047.idx
  store ptr null, ptr %.4049, align 8
  %.4053 = call i32 @add_scaled.29(ptr nonnull %.4049, ptr nonnull %excinfo.31, i64 %.139, double %.4030, ptr %.4047, ptr %.284)
  switch i32 %.4053, label %B5208.endif.if [
    i32 -2, label %B5208.endif.endif
    i32 0, label %B5208.endif.endif
  ]

B5208.endif.if:
  %.4061 = icmp sgt i32 %.4053, 0
  %.4054 = load ptr, ptr %excinfo.31, align 8
  %.4062 = select i1 %.4061, ptr %.4054, ptr undef
  store ptr %.4062, ptr %excinfo, align 8
  br label %common.ret

B5208.endif.endif:
  %exitcond1430.not = icmp eq i64 %.3988, 8
  br i1 %exitcond1430.not, label %B5378.preheader, label %B5206.if

B5378.if:
  %.4102.01182 = phi i64 [ %.4171, %B5378.loopexit ], [ 0, %B5378.preheader ]
  %.4171 = add nuw nsw i64 %.4102.01182, 1
  %.4202.idx = shl i64 %.4102.01182, 4
  %.4202 = getelementptr i8, ptr %arg.ends_dot, i64 %.4202.idx
  store double 0.000000e+00, ptr %.4205, align 8
  %.4209 = call i32 @begin_rate.60(ptr nonnull %.4205, ptr nonnull %excinfo.32, i64 %.575.sroa.0.01194, ptr %.4202)
  %.4219 = load double, ptr %.4205, align 8
  switch i32 %.4209, label %B5380.if [
    i32 -2, label %B5380.endif
    i32 0, label %B5380.endif
  ]

B5380.if:
  %.4217 = icmp sgt i32 %.4209, 0
  %.4210 = load ptr, ptr %excinfo.32, align 8
  %.4218 = select i1 %.4217, ptr %.4210, ptr undef
  store ptr %.4218, ptr %excinfo, align 8
  br label %common.ret

B5380.endif:
  store double 0.000000e+00, ptr %.4232, align 8
  %.4236 = call i32 @size_rate.66(ptr nonnull %.4232, ptr nonnull %excinfo.33, i64 %.575.sroa.0.01194, i64 %arg.step_count, ptr %.4202)
  switch i32 %.4236, label %B5380.endif.if [
    i32 -2, label %B5380.endif.endif
    i32 0, label %B5380.endif.endif
  ]

B5380.endif.if:
  %.4244 = icmp sgt i32 %.4236, 0
  %.4237 = load ptr, ptr %excinfo.33, align 8
  %.4245 = select i1 %.4244, ptr %.4237, ptr undef
  store ptr %.4245, ptr %excinfo, align 8
  br label %common.ret

B5380.endif.endif:
  %.4246 = load double, ptr %.4232, align 8
  %.4257 = fmul contract double %.3708, %.4246
  %.4258 = fadd contract double %.4219, %.4257
  %.4259 = fneg contract double %.4258
  %.4264 = fdiv contract double %.4259, %.640
  %.4270 = mul nsw i64 %.4102.01182, %arg.edge_count
  %.4272 = add nsw i64 %.4270, %.3590.01185
  %.4274 = mul nsw i64 %.4272, %.109
  %.4276 = getelementptr double, ptr %arg.outputs, i64 %.4274
  %invariant.gep1176 = getelementptr double, ptr %.284, i64 %.4102.01182
  br i1 %.43601178.not, label %B5378.loopexit, label %B5582.if

B5582.if:
  %.4304.01179 = phi i64 [ %.4373, %B5582.if ], [ 0, %B5380.endif.endif ]
  %.4373 = add nuw nsw i64 %.4304.01179, 1
  %.idx912 = shl i64 %.4304.01179, 6
  %gep1177 = getelementptr i8, ptr %invariant.gep1176, i64 %.idx912
  %.4403 = load double, ptr %gep1177, align 8
  %.4405 = getelementptr double, ptr %.149, i64 %.4304.01179
  %.4406 = load double, ptr %.4405, align 8
  %.4408 = fmul contract double %.4264, %.4406
  %.4409 = fadd contract double %.4403, %.4408
  %.4411 = getelementptr double, ptr %.4276, i64 %.4304.01179
  store double %.4409, ptr %.4411, align 8
  %exitcond1431.not = icmp eq i64 %.109, %.4373
  br i1 %exitcond1431.not, label %B5378.loopexit, label %B5582.if

B5662.if:
  %.4463 = icmp sgt i32 %.4455, 0
  %.4456 = load ptr, ptr %excinfo.34, align 8
  %.4464 = select i1 %.4463, ptr %.4456, ptr undef
  store ptr %.4464, ptr %excinfo, align 8
  br label %common.ret

B5662.endif:
  %.585 = icmp sgt i64 %.531.11193, 0
  %.598 = zext i1 %.585 to i64
  %.528.1 = add i64 %.528.11192, %.598
  %.594 = sext i1 %.585 to i64
  %.531.1 = add nsw i64 %.531.11193, %.594
  %.575.sroa.0.0 = select i1 %.585, i64 %.528.11192, i64 0
  br i1 %.585, label %B1408, label %B5720
}

define internal i32 @moving_groups.59(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout) noinline {
entry:
  %.11 = getelementptr i8, ptr %arg.layout, i64 32
  %.12 = load i64, ptr %.11, align 8
  %.9447.not = icmp slt i64 %.12, 1
  br i1 %.9447.not, label %B190, label %B60.if

B150:
  %0 = getelementptr i8, ptr %1, i64 64
  %.154 = load i64, ptr %0, align 8
  %.156 = add nsw i64 %.154, %count.2.050
  br label %B188

B188:
  %count.3.1 = phi i64 [ %.156, %B150 ], [ %count.2.050, %B60.if ]
  %exitcond.not = icmp eq i64 %.12, %.107
  br i1 %exitcond.not, label %B190, label %B60.if

B190:
  %count.2.0.lcssa = phi i64 [ 0, %entry ], [ %count.3.1, %B188 ]
  store i64 %count.2.0.lcssa, ptr %retptr, align 8
  ret i32 0

B60.if:
  %count.2.050 = phi i64 [ %count.3.1, %B188 ], [ 0, %entry ]
  %.36.048 = phi i64 [ %.107, %B188 ], [ 0, %entry ]
  %.107 = add nuw nsw i64 %.36.048, 1
  %.idx = mul i64 %.36.048, 88
  %1 = getelementptr i8, ptr %arg.layout, i64 %.idx
  %.144 = getelementptr i8, ptr %1, i64 144
  %.145 = load i64, ptr %.144, align 8
  %.146.not = icmp eq i64 %.145, -1
  br i1 %.146.not, label %B188, label %B150
}

define internal i32 @begin_rate.60(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.step, ptr noalias %arg.ends) noinline {
entry:
  %.8 = icmp eq i64 %arg.step, 0
  br i1 %.8, label %B16, label %B34

B16:
  %.12 = load double, ptr %arg.ends, align 8
  br label %B34

B34:
  %"$phi34.0.2.0" = phi double [ %.12, %B16 ], [ 0.000000e+00, %entry ]
  store double %"$phi34.0.2.0", ptr %retptr, align 8
  ret i32 0
}

define internal i32 @size_rate.66(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.step, i64 %arg.count, ptr noalias %arg.ends) noinline {
entry:
  %.31 = alloca double, align 8
  store double 0.000000e+00, ptr %.31, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.11 = add nsw i64 %arg.count, -1
  %.13 = icmp eq i64 %arg.step, %.11
  br i1 %.13, label %B22, label %B40

B22:
  %.16 = getelementptr i8, ptr %arg.ends, i64 8
  %.17 = load double, ptr %.16, align 8
  br label %B40

B40:
  %"$phi40.0.2.0" = phi double [ %.17, %B22 ], [ 0.000000e+00, %entry ]
  store double 0.000000e+00, ptr %.31, align 8
  %.35 = call i32 @begin_rate.60(ptr nonnull %.31, ptr nonnull %excinfo.1, i64 %arg.step, ptr %arg.ends)
  switch i32 %.35, label %B40.if [
    i32 -2, label %B40.endif
    i32 0, label %B40.endif
  ]

B40.if:
  %.43 = icmp sgt i32 %.35, 0
  %.36 = load ptr, ptr %excinfo.1, align 8
  %.44 = select i1 %.43, ptr %.36, ptr undef
  store ptr %.44, ptr %excinfo, align 8
  br label %common.ret

common.ret:
  %common.ret.op = phi i32 [ 0, %B40.endif ], [ %.35, %B40.if ]
  ret i32 %common.ret.op

B40.endif:
  %.45 = load double, ptr %.31, align 8
  %.61 = fsub contract double %"$phi40.0.2.0", %.45
  store double %.61, ptr %retptr, align 8
  br label %common.ret
}

define internal i32 @multiply_sides.61(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.count, ptr noalias %arg.rows, ptr noalias %arg.columns, ptr noalias %arg.places, ptr noalias %arg.J, ptr noalias %arg.entries_dot, ptr noalias %arg.stage, ptr noalias %arg.place_dot, ptr noalias %arg.sides) noinline {
entry:
  %.11082.not = icmp slt i64 %arg.count, 1
  br i1 %.11082.not, label %B314, label %B34.if

B34.loopexit:
  %.123 = add nuw nsw i64 %.52.083, 1
  %exitcond85.not = icmp eq i64 %arg.count, %.123
  br i1 %exitcond85.not, label %B314, label %B34.if

B314:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.52.083 = phi i64 [ %.123, %B34.loopexit ], [ 0, %entry ]
  %.153 = getelementptr i32, ptr %arg.rows, i64 %.52.083
  %.154 = load i32, ptr %.153, align 4
  %.155 = sext i32 %.154 to i64
  %.159 = getelementptr i32, ptr %arg.columns, i64 %.52.083
  %.160 = load i32, ptr %.159, align 4
  %.161 = sext i32 %.160 to i64
  %.171 = getelementptr i32, ptr %arg.places, i64 %.52.083
  %.172 = load i32, ptr %.171, align 4
  %.174 = sext i32 %.172 to i64
  %.175 = getelementptr double, ptr %arg.J, i64 %.174
  %.176 = load double, ptr %.175, align 8
  %.183 = getelementptr double, ptr %arg.stage, i64 %.161
  %.184 = load double, ptr %.183, align 8
  %.idx = shl nsw i64 %.155, 6
  %0 = getelementptr i8, ptr %arg.sides, i64 %.idx
  %.idx78 = shl nsw i64 %.161, 6
  %1 = getelementptr i8, ptr %arg.place_dot, i64 %.idx78
  %.idx79 = shl i64 %.52.083, 6
  %2 = getelementptr i8, ptr %arg.entries_dot, i64 %.idx79
  br label %B198.if

B198.if:
  %.214.080 = phi i64 [ 0, %B34.if ], [ %.283, %B198.if ]
  %.283 = add nuw nsw i64 %.214.080, 1
  %.311 = getelementptr double, ptr %0, i64 %.214.080
  %.312 = load double, ptr %.311, align 8
  %.316 = getelementptr double, ptr %1, i64 %.214.080
  %.317 = load double, ptr %.316, align 8
  %.319 = fmul contract double %.176, %.317
  %.324 = getelementptr double, ptr %2, i64 %.214.080
  %.325 = load double, ptr %.324, align 8
  %.327 = fmul contract double %.184, %.325
  %.328 = fadd contract double %.319, %.327
  %.329 = fadd contract double %.312, %.328
  store double %.329, ptr %.311, align 8
  %exitcond.not = icmp eq i64 %.283, 8
  br i1 %exitcond.not, label %B34.loopexit, label %B198.if
}

define internal i32 @add_scaled.68(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, double %arg.factor, ptr noalias %arg.x, ptr noalias %arg.y) {
entry:
  br label %B34.if

B90:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.034 = phi i64 [ 0, %entry ], [ %.108, %B34.if ]
  %.108 = add nuw nsw i64 %.37.034, 1
  %.134 = getelementptr double, ptr %arg.y, i64 %.37.034
  %.135 = load double, ptr %.134, align 8
  %.137 = getelementptr double, ptr %arg.x, i64 %.37.034
  %.138 = load double, ptr %.137, align 8
  %.140 = fmul contract double %arg.factor, %.138
  %.141 = fadd contract double %.135, %.140
  store double %.141, ptr %.134, align 8
  %exitcond.not = icmp eq i64 %.108, 8
  br i1 %exitcond.not, label %B90, label %B34.if
}

define internal i32 @mark_moving.62(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.numbers_dot, ptr noalias %arg.moving) noinline {
entry:
  %.17 = getelementptr i8, ptr %arg.layout, i64 32
  %.18 = load i64, ptr %.17, align 8
  %.100138.not = icmp slt i64 %.18, 1
  br i1 %.100138.not, label %B424, label %B60.if

B152:
  %0 = getelementptr i8, ptr %2, i64 64
  %.168 = getelementptr i8, ptr %2, i64 88
  %.169 = load i64, ptr %.168, align 8
  %.173 = getelementptr i8, ptr %2, i64 72
  %.174 = load i64, ptr %.173, align 8
  %.175 = mul i64 %.174, %.169
  %.183 = load i64, ptr %0, align 8
  %.263134.not = icmp slt i64 %.183, 1
  br i1 %.263134.not, label %B425, label %B276.if.lr.ph

B276.if.lr.ph:
  %.304 = getelementptr i8, ptr %2, i64 120
  %.305 = load i64, ptr %.304, align 8
  %.396131.not = icmp slt i64 %.175, 1
  %1 = getelementptr double, ptr %arg.numbers_dot, i64 %.305
  br label %B276.if

B398:
  store double 1.000000e+00, ptr %.314, align 8
  br label %B408

B408:
  %exitcond.not = icmp eq i64 %.175, %.409
  br i1 %exitcond.not, label %B410, label %B364.if

B410:
  %.454 = add nsw i64 %at.2.1137, 1
  %exitcond142.not = icmp eq i64 %.276, %.183
  br i1 %exitcond142.not, label %B425, label %B276.if

B424:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B425:
  %at.4.1 = phi i64 [ %at.3.0141, %B60.if ], [ %at.3.0141, %B152 ], [ %.454, %B410 ]
  %exitcond143.not = icmp eq i64 %.18, %.113
  br i1 %exitcond143.not, label %B424, label %B60.if

B60.if:
  %at.3.0141 = phi i64 [ %at.4.1, %B425 ], [ 0, %entry ]
  %.42.0139 = phi i64 [ %.113, %B425 ], [ 0, %entry ]
  %.113 = add nuw nsw i64 %.42.0139, 1
  %.idx = mul i64 %.42.0139, 88
  %2 = getelementptr i8, ptr %arg.layout, i64 %.idx
  %.146 = getelementptr i8, ptr %2, i64 144
  %.147 = load i64, ptr %.146, align 8
  %.148 = icmp eq i64 %.147, -1
  br i1 %.148, label %B425, label %B152

B276.if:
  %at.2.1137 = phi i64 [ %at.3.0141, %B276.if.lr.ph ], [ %.454, %B410 ]
  %.207.0135 = phi i64 [ 0, %B276.if.lr.ph ], [ %.276, %B410 ]
  %.276 = add nuw nsw i64 %.207.0135, 1
  %.314 = getelementptr double, ptr %arg.moving, i64 %at.2.1137
  store double 0.000000e+00, ptr %.314, align 8
  br i1 %.396131.not, label %B410, label %B364.if.lr.ph

B364.if.lr.ph:
  %3 = mul nuw nsw i64 %.207.0135, %.175
  %4 = getelementptr double, ptr %1, i64 %3
  br label %B364.if

B364.if:
  %.340.0132 = phi i64 [ 0, %B364.if.lr.ph ], [ %.409, %B408 ]
  %.409 = add nuw nsw i64 %.340.0132, 1
  %.437 = getelementptr double, ptr %4, i64 %.340.0132
  %.438 = load double, ptr %.437, align 8
  %.439 = fcmp contract une double %.438, 0.000000e+00
  br i1 %.439, label %B398, label %B408
}

define internal i32 @push_drive.63(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, i64 %arg.which, ptr noalias %arg.Y_dot, ptr noalias %arg.numbers_dot, ptr noalias %arg.rates_dot, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.319 = alloca ptr, align 8
  store ptr null, ptr %.319, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.41 = getelementptr i8, ptr %arg.layout, i64 40
  %.42 = load i64, ptr %.41, align 8
  %.124126.not = icmp slt i64 %.42, 1
  br i1 %.124126.not, label %B496, label %B56.if.lr.ph

B56.if.lr.ph:
  %.163 = getelementptr i8, ptr %arg.layout, i64 32
  %.482 = getelementptr i8, ptr %arg.layout, i64 8
  br label %B56.if

B56.loopexit:
  %exitcond131.not = icmp eq i64 %.137, %.42
  br i1 %exitcond131.not, label %B496, label %B56.if

B248.loopexit:
  %exitcond130.not = icmp eq i64 %.282, %.189
  br i1 %exitcond130.not, label %B56.loopexit, label %B248.if

B456:
  %.489 = getelementptr double, ptr %arg.out, i64 %.380.0121
  %.490 = load double, ptr %.489, align 8
  %.499 = getelementptr double, ptr %arg.rates_dot, i64 %.484
  store double %.490, ptr %.499, align 8
  br label %B490

B490:
  %exitcond.not = icmp eq i64 %.181, %.449
  br i1 %exitcond.not, label %B248.loopexit, label %B406.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B496 ], [ %.323, %B250.if ]
  ret i32 %common.ret.op

B496:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B56.if:
  %.66.0127 = phi i64 [ 0, %B56.if.lr.ph ], [ %.137, %B56.loopexit ]
  %.137 = add nuw nsw i64 %.66.0127, 1
  %.164 = load i64, ptr %.163, align 8
  %.165 = add nsw i64 %.164, %.66.0127
  %.166 = mul nsw i64 %.165, 11
  %.167 = add nsw i64 %.166, 8
  %0 = getelementptr i64, ptr %arg.layout, i64 %.166
  %.174 = getelementptr i8, ptr %0, i64 96
  %.175 = load i64, ptr %.174, align 8
  %.179 = getelementptr i8, ptr %0, i64 72
  %.180 = load i64, ptr %.179, align 8
  %.181 = mul i64 %.180, %.175
  %.188 = getelementptr i64, ptr %arg.layout, i64 %.167
  %.189 = load i64, ptr %.188, align 8
  %.269123.not = icmp slt i64 %.189, 1
  br i1 %.269123.not, label %B56.loopexit, label %B248.if.lr.ph

B248.if.lr.ph:
  %.346 = getelementptr i8, ptr %0, i64 128
  %.436120.not = icmp slt i64 %.181, 1
  br label %B248.if

B248.if:
  %.213.0124 = phi i64 [ 0, %B248.if.lr.ph ], [ %.282, %B248.loopexit ]
  %.282 = add nuw nsw i64 %.213.0124, 1
  store ptr null, ptr %.319, align 8
  %.323 = call i32 @push.69(ptr nonnull %.319, ptr nonnull %excinfo.1, ptr %arg.layout, i64 %.167, i64 %arg.which, i64 %.213.0124, ptr %arg.derived, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.Y_dot, ptr %arg.numbers_dot, ptr %arg.local, ptr %arg.out)
  switch i32 %.323, label %B250.if [
    i32 -2, label %B250.endif
    i32 0, label %B250.endif
  ]

B250.if:
  %.331 = icmp sgt i32 %.323, 0
  %.324 = load ptr, ptr %excinfo.1, align 8
  %.332 = select i1 %.331, ptr %.324, ptr undef
  store ptr %.332, ptr %excinfo, align 8
  br label %common.ret

B250.endif:
  %.347 = load i64, ptr %.346, align 8
  %.349 = mul nsw i64 %.213.0124, %.181
  %1 = getelementptr i32, ptr %arg.rows, i64 %.347
  %.352 = getelementptr i32, ptr %1, i64 %.349
  br i1 %.436120.not, label %B248.loopexit, label %B406.if.lr.ph

B406.if.lr.ph:
  %.483 = load i64, ptr %.482, align 8
  br label %B406.if

B406.if:
  %.380.0121 = phi i64 [ 0, %B406.if.lr.ph ], [ %.449, %B490 ]
  %.449 = add nuw nsw i64 %.380.0121, 1
  %.479 = getelementptr i32, ptr %.352, i64 %.380.0121
  %.480 = load i32, ptr %.479, align 4
  %.484 = sext i32 %.480 to i64
  %.485 = icmp sgt i64 %.483, %.484
  br i1 %.485, label %B456, label %B490
}

define internal i32 @push_jacobian.64(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.pos, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.Y_dot, ptr noalias %arg.numbers_dot, ptr noalias %arg.J_dot, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.350 = alloca ptr, align 8
  store ptr null, ptr %.350, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.510 = alloca ptr, align 8
  store ptr null, ptr %.510, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.542 = alloca ptr, align 8
  store ptr null, ptr %.542, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.38 = getelementptr i8, ptr %arg.layout, i64 16
  %.39 = load i64, ptr %.38, align 8
  %.40 = add nsw i64 %.39, 1
  %.42 = getelementptr i8, ptr %arg.layout, i64 24
  %.43 = load i64, ptr %.42, align 8
  %.44 = add nsw i64 %.40, %.43
  %.126123.not = icmp slt i64 %.44, 1
  br i1 %.126123.not, label %B106, label %B90.if.preheader

B90.if.preheader:
  %0 = shl nuw i64 %.44, 3
  call void @llvm.memset.p0.i64(ptr align 8 %arg.J_dot, i8 0, i64 %0, i1 false)
  br label %B106

B106:
  %.173 = getelementptr i8, ptr %arg.layout, i64 32
  %.174 = load i64, ptr %.173, align 8
  %.255129.not = icmp slt i64 %.174, 1
  br i1 %.255129.not, label %B698, label %B160.if

B376:
  %.332 = getelementptr i8, ptr %3, i64 56
  %.333 = load i64, ptr %.332, align 8
  %.335 = getelementptr double, ptr %arg.numbers_dot, i64 %.333
  %.343 = load i64, ptr %3, align 8
  %.345 = mul nsw i64 %.343, %.318
  store ptr null, ptr %.350, align 8
  %.354 = call i32 @scatter.2(ptr nonnull %.350, ptr nonnull %excinfo.1, i64 %.345, ptr %.304, ptr %.335, ptr %arg.J_dot)
  switch i32 %.354, label %B376.if [
    i32 -2, label %B699
    i32 0, label %B699
  ]

B508:
  %.381 = load i64, ptr %3, align 8
  %.461126.not = icmp slt i64 %.381, 1
  br i1 %.461126.not, label %B699, label %B566.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B698 ], [ %.546, %B568.endif.if ], [ %.354, %B376.if ], [ %.514, %B568.if ]
  ret i32 %common.ret.op

B698:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B699:
  %exitcond135.not = icmp eq i64 %.174, %.268
  br i1 %exitcond135.not, label %B698, label %B160.if

B160.if:
  %.198.0130 = phi i64 [ %.268, %B699 ], [ 0, %B106 ]
  %.268 = add nuw nsw i64 %.198.0130, 1
  %1 = mul nuw nsw i64 %.198.0130, 11
  %2 = add nuw nsw i64 %1, 8
  %3 = getelementptr i64, ptr %arg.layout, i64 %2
  %.301 = getelementptr i8, ptr %3, i64 72
  %.302 = load i64, ptr %.301, align 8
  %.304 = getelementptr i32, ptr %arg.pos, i64 %.302
  %.311 = getelementptr i8, ptr %3, i64 40
  %.312 = load i64, ptr %.311, align 8
  %.316 = getelementptr i8, ptr %3, i64 8
  %.317 = load i64, ptr %.316, align 8
  %.318 = mul nsw i64 %.317, %.312
  %.325 = getelementptr i8, ptr %3, i64 80
  %.326 = load i64, ptr %.325, align 8
  %.327 = icmp eq i64 %.326, -1
  br i1 %.327, label %B376, label %B508

B376.if:
  %.362 = icmp sgt i32 %.354, 0
  %.355 = load ptr, ptr %excinfo.1, align 8
  %.363 = select i1 %.362, ptr %.355, ptr undef
  store ptr %.363, ptr %excinfo, align 8
  br label %common.ret

B566.if:
  %.405.0127 = phi i64 [ %.474, %B568.endif.endif ], [ 0, %B508 ]
  %.474 = add nuw nsw i64 %.405.0127, 1
  store ptr null, ptr %.510, align 8
  %.514 = call i32 @push.69(ptr nonnull %.510, ptr nonnull %excinfo.2, ptr %arg.layout, i64 %2, i64 1, i64 %.405.0127, ptr %arg.derived, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.Y_dot, ptr %arg.numbers_dot, ptr %arg.local, ptr %arg.out)
  switch i32 %.514, label %B568.if [
    i32 -2, label %B568.endif
    i32 0, label %B568.endif
  ]

B568.if:
  %.522 = icmp sgt i32 %.514, 0
  %.515 = load ptr, ptr %excinfo.2, align 8
  %.523 = select i1 %.522, ptr %.515, ptr undef
  store ptr %.523, ptr %excinfo, align 8
  br label %common.ret

B568.endif:
  %.536 = mul nsw i64 %.405.0127, %.318
  %.538 = getelementptr i32, ptr %.304, i64 %.536
  store ptr null, ptr %.542, align 8
  %.546 = call i32 @scatter.2(ptr nonnull %.542, ptr nonnull %excinfo.3, i64 %.318, ptr %.538, ptr %arg.out, ptr %arg.J_dot)
  switch i32 %.546, label %B568.endif.if [
    i32 -2, label %B568.endif.endif
    i32 0, label %B568.endif.endif
  ]

B568.endif.if:
  %.554 = icmp sgt i32 %.546, 0
  %.547 = load ptr, ptr %excinfo.3, align 8
  %.555 = select i1 %.554, ptr %.547, ptr undef
  store ptr %.555, ptr %excinfo, align 8
  br label %common.ret

B568.endif.endif:
  %exitcond.not = icmp eq i64 %.381, %.474
  br i1 %exitcond.not, label %B699, label %B566.if
}

define internal i32 @add_masses.65(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.mass, double %arg.factor, ptr noalias %arg.x, ptr noalias %arg.y) noinline {
entry:
  %.9874.not = icmp slt i64 %arg.n, 1
  br i1 %.9874.not, label %B202, label %B34.if

B34.loopexit:
  %.111 = add nuw nsw i64 %.40.075, 1
  %exitcond77.not = icmp eq i64 %arg.n, %.111
  br i1 %exitcond77.not, label %B202, label %B34.if

B202:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.40.075 = phi i64 [ %.111, %B34.loopexit ], [ 0, %entry ]
  %.141 = getelementptr double, ptr %arg.mass, i64 %.40.075
  %.142 = load double, ptr %.141, align 8
  %.144 = fmul contract double %arg.factor, %.142
  %.266 = shl nsw i64 %.40.075, 3
  br label %B100.if

B100.if:
  %.171.072 = phi i64 [ 0, %B34.if ], [ %.240, %B100.if ]
  %.240 = add nuw nsw i64 %.171.072, 1
  %.267 = add nuw nsw i64 %.171.072, %.266
  %.269 = getelementptr double, ptr %arg.y, i64 %.267
  %.270 = load double, ptr %.269, align 8
  %.275 = getelementptr double, ptr %arg.x, i64 %.267
  %.276 = load double, ptr %.275, align 8
  %.278 = fmul contract double %.144, %.276
  %.279 = fadd contract double %.270, %.278
  store double %.279, ptr %.269, align 8
  %exitcond.not = icmp eq i64 %.240, 8
  br i1 %exitcond.not, label %B34.loopexit, label %B100.if
}

define internal i32 @push_numbers.67(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.numbers_dot, ptr noalias %arg.moving, ptr noalias %arg.r_dot, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.596 = alloca ptr, align 8
  store ptr null, ptr %.596, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.41 = getelementptr i8, ptr %arg.layout, i64 32
  %.42 = load i64, ptr %.41, align 8
  %.125302.not = icmp slt i64 %.42, 1
  br i1 %.125302.not, label %B1404, label %B62.if

B276:
  %.204 = getelementptr i8, ptr %12, i64 112
  %.205 = load i64, ptr %.204, align 8
  %.207 = getelementptr i32, ptr %arg.idx, i64 %.205
  %.217 = load i64, ptr %13, align 8
  %.219 = mul nsw i64 %.217, %.179
  %.301299.not = icmp slt i64 %.219, 1
  br i1 %.301299.not, label %B1405, label %B400.if.lr.ph

B400.if.lr.ph:
  %0 = getelementptr double, ptr %arg.numbers_dot, i64 %.190
  br label %B400.if

B434:
  %.352 = getelementptr i32, ptr %.174, i64 %.245.0300
  %.353 = load i32, ptr %.352, align 4
  %.356 = load i64, ptr %arg.layout, align 8
  %.357 = sext i32 %.353 to i64
  %.358 = icmp sgt i64 %.356, %.357
  br i1 %.358, label %B480, label %B588

B480:
  %.367.idx = shl nsw i64 %.357, 6
  %.367 = getelementptr i8, ptr %arg.r_dot, i64 %.367.idx
  %.368 = load double, ptr %.367, align 8
  %.377 = getelementptr i32, ptr %.207, i64 %.245.0300
  %.378 = load i32, ptr %.377, align 4
  %.382 = sext i32 %.378 to i64
  %.383 = getelementptr double, ptr %arg.Y, i64 %.382
  %.384 = load double, ptr %.383, align 8
  %.385 = fmul contract double %.347, %.384
  %.386 = fadd contract double %.368, %.385
  store double %.386, ptr %.367, align 8
  br label %B588

B588:
  %exitcond308.not = icmp eq i64 %.314, %.219
  br i1 %exitcond308.not, label %B1405, label %B400.if

B594:
  %.420 = getelementptr i8, ptr %12, i64 80
  %.421 = load i64, ptr %.420, align 8
  %.423 = mul i64 %.421, %.179
  %.427 = getelementptr i8, ptr %12, i64 88
  %.428 = load i64, ptr %.427, align 8
  %.430 = mul i64 %.428, %.179
  %.440 = getelementptr i8, ptr %12, i64 96
  %.441 = load i64, ptr %.440, align 8
  %.443 = mul i64 %.441, %.179
  %.453 = load i64, ptr %13, align 8
  %.534295.not = icmp slt i64 %.453, 1
  br i1 %.534295.not, label %B1405, label %B768.if.lr.ph

B768.if.lr.ph:
  %.585 = getelementptr i8, ptr %12, i64 112
  %.622 = getelementptr double, ptr %arg.local, i64 %.423
  %storemerge278 = call i64 @llvm.smax.i64(i64 %.423, i64 0)
  %.706286.not = icmp slt i64 %.423, 1
  %storemerge279 = call i64 @llvm.smax.i64(i64 %.430, i64 0)
  %.832289.not = icmp slt i64 %.430, 1
  %1 = getelementptr double, ptr %.622, i64 %.423
  %2 = getelementptr double, ptr %arg.numbers, i64 %.190
  %.idx = shl i64 %.198, 4
  %3 = getelementptr i8, ptr %arg.derived, i64 %.idx
  %.908 = getelementptr i8, ptr %3, i64 16
  %.1002292.not = icmp slt i64 %.443, 1
  %4 = shl nuw i64 %storemerge278, 3
  %5 = shl i64 %.190, 3
  %6 = shl i64 %.428, 3
  %7 = mul i64 %6, %.179
  %8 = shl nuw i64 %storemerge279, 3
  %9 = add i64 %at.3.0305, %.453
  %10 = getelementptr i8, ptr %arg.numbers_dot, i64 %5
  br label %B768.if

B798:
  %.586 = load i64, ptr %.585, align 8
  %.589 = mul nsw i64 %.477.0296, %.423
  %11 = getelementptr i32, ptr %arg.idx, i64 %.586
  %.592 = getelementptr i32, ptr %11, i64 %.589
  store ptr null, ptr %.596, align 8
  %.600 = call i32 @gather.3(ptr nonnull %.596, ptr nonnull %excinfo.1, i64 %.423, ptr %.592, ptr %arg.Y, ptr %arg.local)
  switch i32 %.600, label %B798.if [
    i32 -2, label %B798.endif
    i32 0, label %B798.endif
  ]

B980:
  br i1 %.832289.not, label %B1062, label %B1010.if.lr.ph

B1010.if.lr.ph:
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1, ptr align 8 %scevgep, i64 %8, i1 false)
  br label %B1062

B1062:
  %.900 = mul nsw i64 %.477.0296, %.430
  %.904 = getelementptr double, ptr %2, i64 %.900
  %.909 = load i64, ptr %.908, align 8
  %.910 = inttoptr i64 %.909 to ptr
  call void %.910(ptr %arg.local, ptr %.904, ptr %arg.out)
  %.914 = mul nsw i64 %.477.0296, %.443
  %.918 = getelementptr i32, ptr %.174, i64 %.914
  br i1 %.1002292.not, label %B1386, label %B1262.if.lr.ph

B1262.if.lr.ph:
  %.1049 = load i64, ptr %arg.layout, align 8
  br label %B1262.if

B1312:
  %.1060.idx = shl nsw i64 %.1050, 6
  %.1060 = getelementptr i8, ptr %arg.r_dot, i64 %.1060.idx
  %.1061 = load double, ptr %.1060, align 8
  %.1064 = getelementptr double, ptr %arg.out, i64 %.946.0293
  %.1065 = load double, ptr %.1064, align 8
  %.1068 = fadd contract double %.1061, %.1065
  store double %.1068, ptr %.1060, align 8
  br label %B1384

B1384:
  %exitcond.not = icmp eq i64 %.443, %.1015
  br i1 %exitcond.not, label %B1386, label %B1262.if

B1386:
  %.1085 = add nsw i64 %at.2.1298, 1
  %exitcond307.not = icmp eq i64 %.547, %.453
  br i1 %exitcond307.not, label %B1405, label %B768.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B1404 ], [ %.600, %B798.if ]
  ret i32 %common.ret.op

B1404:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B1405:
  %at.4.1 = phi i64 [ %at.3.0305, %B276 ], [ %at.3.0305, %B588 ], [ %at.3.0305, %B594 ], [ %9, %B1386 ]
  %exitcond309.not = icmp eq i64 %.42, %.138
  br i1 %exitcond309.not, label %B1404, label %B62.if

B62.if:
  %at.3.0305 = phi i64 [ %at.4.1, %B1405 ], [ 0, %entry ]
  %.66.0303 = phi i64 [ %.138, %B1405 ], [ 0, %entry ]
  %.138 = add nuw nsw i64 %.66.0303, 1
  %.idx283 = mul i64 %.66.0303, 88
  %12 = getelementptr i8, ptr %arg.layout, i64 %.idx283
  %13 = getelementptr i8, ptr %12, i64 64
  %.171 = getelementptr i8, ptr %12, i64 128
  %.172 = load i64, ptr %.171, align 8
  %.174 = getelementptr i32, ptr %arg.rows, i64 %.172
  %.178 = getelementptr i8, ptr %12, i64 72
  %.179 = load i64, ptr %.178, align 8
  %.189 = getelementptr i8, ptr %12, i64 120
  %.190 = load i64, ptr %.189, align 8
  %.197 = getelementptr i8, ptr %12, i64 144
  %.198 = load i64, ptr %.197, align 8
  %.199 = icmp eq i64 %.198, -1
  br i1 %.199, label %B276, label %B594

B400.if:
  %.245.0300 = phi i64 [ 0, %B400.if.lr.ph ], [ %.314, %B588 ]
  %.314 = add nuw nsw i64 %.245.0300, 1
  %.346 = getelementptr double, ptr %0, i64 %.245.0300
  %.347 = load double, ptr %.346, align 8
  %.348 = fcmp contract une double %.347, 0.000000e+00
  br i1 %.348, label %B434, label %B588

B768.if:
  %at.2.1298 = phi i64 [ %at.3.0305, %B768.if.lr.ph ], [ %.1085, %B1386 ]
  %.477.0296 = phi i64 [ 0, %B768.if.lr.ph ], [ %.547, %B1386 ]
  %14 = mul i64 %7, %.477.0296
  %scevgep = getelementptr i8, ptr %10, i64 %14
  %.547 = add nuw nsw i64 %.477.0296, 1
  %.577 = getelementptr double, ptr %arg.moving, i64 %at.2.1298
  %.578 = load double, ptr %.577, align 8
  %.579 = fcmp contract une double %.578, 0.000000e+00
  br i1 %.579, label %B798, label %B1386

B798.if:
  %.608 = icmp sgt i32 %.600, 0
  %.601 = load ptr, ptr %excinfo.1, align 8
  %.609 = select i1 %.608, ptr %.601, ptr undef
  store ptr %.609, ptr %excinfo, align 8
  br label %common.ret

B798.endif:
  br i1 %.706286.not, label %B980, label %B964.if.preheader

B964.if.preheader:
  call void @llvm.memset.p0.i64(ptr align 8 %.622, i8 0, i64 %4, i1 false)
  br label %B980

B1262.if:
  %.946.0293 = phi i64 [ 0, %B1262.if.lr.ph ], [ %.1015, %B1384 ]
  %.1015 = add nuw nsw i64 %.946.0293, 1
  %.1045 = getelementptr i32, ptr %.918, i64 %.946.0293
  %.1046 = load i32, ptr %.1045, align 4
  %.1050 = sext i32 %.1046 to i64
  %.1051 = icmp sgt i64 %.1049, %.1050
  br i1 %.1051, label %B1312, label %B1384
}

define internal i32 @push.69(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, i64 %arg.table, i64 %arg.which, i64 %arg.group, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.Y_dot, ptr noalias %arg.numbers_dot, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.69 = alloca ptr, align 8
  store ptr null, ptr %.69, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.98 = alloca ptr, align 8
  store ptr null, ptr %.98, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %0 = getelementptr i64, ptr %arg.layout, i64 %arg.table
  %.35 = getelementptr i8, ptr %0, i64 8
  %.36 = load i64, ptr %.35, align 8
  %.40 = getelementptr i8, ptr %0, i64 16
  %.41 = load i64, ptr %.40, align 8
  %.42 = mul i64 %.41, %.36
  %.46 = getelementptr i8, ptr %0, i64 24
  %.47 = load i64, ptr %.46, align 8
  %.48 = mul nsw i64 %.47, %.36
  %.52 = getelementptr i8, ptr %0, i64 48
  %.53 = load i64, ptr %.52, align 8
  %.54 = mul nsw i64 %.42, %arg.group
  %1 = getelementptr i32, ptr %arg.idx, i64 %.53
  %.56 = getelementptr i32, ptr %1, i64 %.54
  %.60 = getelementptr i8, ptr %0, i64 56
  %.61 = load i64, ptr %.60, align 8
  %.62 = mul nsw i64 %.48, %arg.group
  %.63 = add nsw i64 %.61, %.62
  store ptr null, ptr %.69, align 8
  %.73 = call i32 @gather.3(ptr nonnull %.69, ptr nonnull %excinfo.1, i64 %.42, ptr %.56, ptr %arg.Y, ptr %arg.local)
  switch i32 %.73, label %B0.if [
    i32 -2, label %B0.endif
    i32 0, label %B0.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ 0, %B430 ], [ %.102, %B0.endif.if ], [ %.73, %B0.if ]
  ret i32 %common.ret.op

B430:
  %.267 = getelementptr i8, ptr %0, i64 80
  %.268 = load i64, ptr %.267, align 8
  %.279 = getelementptr double, ptr %arg.numbers, i64 %.63
  %.idx = shl i64 %.268, 4
  %2 = getelementptr i8, ptr %arg.derived, i64 %.idx
  %.287 = getelementptr i8, ptr %2, i64 24
  %.288 = load i64, ptr %.287, align 8
  %.289 = inttoptr i64 %.288 to ptr
  call void %.289(ptr %arg.local, ptr %.279, ptr %arg.out)
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B0.if:
  %.81 = icmp sgt i32 %.73, 0
  %.74 = load ptr, ptr %excinfo.1, align 8
  %.82 = select i1 %.81, ptr %.74, ptr undef
  store ptr %.82, ptr %excinfo, align 8
  br label %common.ret

B0.endif:
  %.97 = getelementptr double, ptr %arg.local, i64 %.42
  store ptr null, ptr %.98, align 8
  %.102 = call i32 @gather.3(ptr nonnull %.98, ptr nonnull %excinfo.2, i64 %.42, ptr %.56, ptr %arg.Y_dot, ptr %.97)
  switch i32 %.102, label %B0.endif.if [
    i32 -2, label %B0.endif.endif
    i32 0, label %B0.endif.endif
  ]

B0.endif.if:
  %.110 = icmp sgt i32 %.102, 0
  %.103 = load ptr, ptr %excinfo.2, align 8
  %.111 = select i1 %.110, ptr %.103, ptr undef
  store ptr %.111, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif:
  %.20746.not = icmp slt i64 %.48, 1
  br i1 %.20746.not, label %B430, label %B396.if.lr.ph

B396.if.lr.ph:
  %.124.idx = shl i64 %.42, 4
  %.124 = getelementptr i8, ptr %arg.local, i64 %.124.idx
  %3 = getelementptr double, ptr %arg.numbers_dot, i64 %.63
  %4 = mul i64 %.47, %.36
  %5 = shl i64 %4, 3
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %.124, ptr align 8 %3, i64 %5, i1 false)
  br label %B430
}

define i64 @run_tape(i64 %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, i64 %a8, ptr %a9, ptr %a10) {
  %r = alloca i64, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @run_tape.70(ptr nonnull %r, ptr nonnull %e, i64 %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, i64 %a8, ptr %a9, ptr %a10)
  %v = load i64, ptr %r, align 8
  ret i64 %v
}

define internal i32 @run_tape.70(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.steps, ptr noalias %arg.code, ptr noalias %arg.constants, ptr noalias %arg.starts, ptr noalias %arg.strides, ptr noalias %arg.given, ptr noalias %arg.to, ptr noalias %arg.hops, i64 %arg.rows, ptr noalias %arg.room, ptr noalias %arg.found) noinline {
entry:
  %.166 = alloca i64, align 8
  store i64 0, ptr %.166, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.376 = alloca ptr, align 8
  store ptr null, ptr %.376, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.438 = alloca ptr, align 8
  store ptr null, ptr %.438, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.520 = alloca ptr, align 8
  store ptr null, ptr %.520, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.563 = alloca ptr, align 8
  store ptr null, ptr %.563, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.605 = alloca ptr, align 8
  store ptr null, ptr %.605, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.649 = alloca ptr, align 8
  store ptr null, ptr %.649, align 8
  %excinfo.7 = alloca ptr, align 8
  store ptr null, ptr %excinfo.7, align 8
  %.693 = alloca ptr, align 8
  store ptr null, ptr %.693, align 8
  %excinfo.8 = alloca ptr, align 8
  store ptr null, ptr %excinfo.8, align 8
  %.737 = alloca ptr, align 8
  store ptr null, ptr %.737, align 8
  %excinfo.9 = alloca ptr, align 8
  store ptr null, ptr %excinfo.9, align 8
  %.782 = alloca ptr, align 8
  store ptr null, ptr %.782, align 8
  %excinfo.10 = alloca ptr, align 8
  store ptr null, ptr %excinfo.10, align 8
  %.826 = alloca ptr, align 8
  store ptr null, ptr %.826, align 8
  %excinfo.11 = alloca ptr, align 8
  store ptr null, ptr %excinfo.11, align 8
  %.870 = alloca ptr, align 8
  store ptr null, ptr %.870, align 8
  %excinfo.12 = alloca ptr, align 8
  store ptr null, ptr %excinfo.12, align 8
  %.913 = alloca ptr, align 8
  store ptr null, ptr %.913, align 8
  %excinfo.13 = alloca ptr, align 8
  store ptr null, ptr %excinfo.13, align 8
  %.956 = alloca ptr, align 8
  store ptr null, ptr %.956, align 8
  %excinfo.14 = alloca ptr, align 8
  store ptr null, ptr %excinfo.14, align 8
  %.999 = alloca ptr, align 8
  store ptr null, ptr %.999, align 8
  %excinfo.15 = alloca ptr, align 8
  store ptr null, ptr %excinfo.15, align 8
  %.1042 = alloca ptr, align 8
  store ptr null, ptr %.1042, align 8
  %excinfo.16 = alloca ptr, align 8
  store ptr null, ptr %excinfo.16, align 8
  %.1085 = alloca ptr, align 8
  store ptr null, ptr %.1085, align 8
  %excinfo.17 = alloca ptr, align 8
  store ptr null, ptr %excinfo.17, align 8
  %.1127 = alloca ptr, align 8
  store ptr null, ptr %.1127, align 8
  %excinfo.18 = alloca ptr, align 8
  store ptr null, ptr %excinfo.18, align 8
  %.1172 = alloca ptr, align 8
  store ptr null, ptr %.1172, align 8
  %excinfo.19 = alloca ptr, align 8
  store ptr null, ptr %excinfo.19, align 8
  %.1215 = alloca ptr, align 8
  store ptr null, ptr %.1215, align 8
  %excinfo.20 = alloca ptr, align 8
  store ptr null, ptr %excinfo.20, align 8
  %.1258 = alloca ptr, align 8
  store ptr null, ptr %.1258, align 8
  %excinfo.21 = alloca ptr, align 8
  store ptr null, ptr %excinfo.21, align 8
  %.1301 = alloca ptr, align 8
  store ptr null, ptr %.1301, align 8
  %excinfo.22 = alloca ptr, align 8
  store ptr null, ptr %excinfo.22, align 8
  %.1344 = alloca ptr, align 8
  store ptr null, ptr %.1344, align 8
  %excinfo.23 = alloca ptr, align 8
  store ptr null, ptr %excinfo.23, align 8
  %.1387 = alloca ptr, align 8
  store ptr null, ptr %.1387, align 8
  %excinfo.24 = alloca ptr, align 8
  store ptr null, ptr %excinfo.24, align 8
  %.1429 = alloca ptr, align 8
  store ptr null, ptr %.1429, align 8
  %excinfo.25 = alloca ptr, align 8
  store ptr null, ptr %excinfo.25, align 8
  %.1474 = alloca ptr, align 8
  store ptr null, ptr %.1474, align 8
  %excinfo.26 = alloca ptr, align 8
  store ptr null, ptr %excinfo.26, align 8
  %.1517 = alloca ptr, align 8
  store ptr null, ptr %.1517, align 8
  %excinfo.27 = alloca ptr, align 8
  store ptr null, ptr %excinfo.27, align 8
  %.1560 = alloca ptr, align 8
  store ptr null, ptr %.1560, align 8
  %excinfo.28 = alloca ptr, align 8
  store ptr null, ptr %excinfo.28, align 8
  %.1602 = alloca ptr, align 8
  store ptr null, ptr %.1602, align 8
  %excinfo.29 = alloca ptr, align 8
  store ptr null, ptr %excinfo.29, align 8
  %.1646 = alloca ptr, align 8
  store ptr null, ptr %.1646, align 8
  %excinfo.30 = alloca ptr, align 8
  store ptr null, ptr %excinfo.30, align 8
  %.1690 = alloca ptr, align 8
  store ptr null, ptr %.1690, align 8
  %excinfo.31 = alloca ptr, align 8
  store ptr null, ptr %excinfo.31, align 8
  %.1734 = alloca ptr, align 8
  store ptr null, ptr %.1734, align 8
  %excinfo.32 = alloca ptr, align 8
  store ptr null, ptr %excinfo.32, align 8
  %.1779 = alloca ptr, align 8
  store ptr null, ptr %.1779, align 8
  %excinfo.33 = alloca ptr, align 8
  store ptr null, ptr %excinfo.33, align 8
  %.1821 = alloca ptr, align 8
  store ptr null, ptr %.1821, align 8
  %excinfo.34 = alloca ptr, align 8
  store ptr null, ptr %excinfo.34, align 8
  %.1865 = alloca ptr, align 8
  store ptr null, ptr %.1865, align 8
  %excinfo.35 = alloca ptr, align 8
  store ptr null, ptr %excinfo.35, align 8
  %.1909 = alloca ptr, align 8
  store ptr null, ptr %.1909, align 8
  %excinfo.36 = alloca ptr, align 8
  store ptr null, ptr %excinfo.36, align 8
  %.1953 = alloca ptr, align 8
  store ptr null, ptr %.1953, align 8
  %excinfo.37 = alloca ptr, align 8
  store ptr null, ptr %excinfo.37, align 8
  %.1997 = alloca ptr, align 8
  store ptr null, ptr %.1997, align 8
  %excinfo.38 = alloca ptr, align 8
  store ptr null, ptr %excinfo.38, align 8
  %.2042 = alloca ptr, align 8
  store ptr null, ptr %.2042, align 8
  %excinfo.39 = alloca ptr, align 8
  store ptr null, ptr %excinfo.39, align 8
  %.2083 = alloca ptr, align 8
  store ptr null, ptr %.2083, align 8
  %excinfo.40 = alloca ptr, align 8
  store ptr null, ptr %excinfo.40, align 8
  %.2124 = alloca ptr, align 8
  store ptr null, ptr %.2124, align 8
  %excinfo.41 = alloca ptr, align 8
  store ptr null, ptr %excinfo.41, align 8
  %0 = add nuw i64 %arg.rows, 31
  %.98 = lshr i64 %0, 5
  %.75.inv = icmp slt i64 %arg.rows, 1
  %.120401.not408 = icmp eq i64 %.98, 0
  %.120401.not = select i1 %.75.inv, i1 true, i1 %.120401.not408
  br i1 %.120401.not, label %B3004, label %B52.lr.ph

B52.lr.ph:
  %.64.1404 = add nsw i64 %.98, -1
  %.276398.not = icmp slt i64 %arg.steps, 1
  br label %B52

B48.loopexit:
  %.120 = icmp sgt i64 %.64.1406, 0
  %.133 = add i64 %.61.1405, 32
  %.61.1 = select i1 %.120, i64 %.133, i64 %.61.1405
  %.129 = sext i1 %.120 to i64
  %.64.1 = add nsw i64 %.64.1406, %.129
  %.110.sroa.0.0 = select i1 %.120, i64 %.61.1405, i64 0
  br i1 %.120, label %B52, label %B3004

B52:
  %.110.sroa.0.0407 = phi i64 [ 0, %B52.lr.ph ], [ %.110.sroa.0.0, %B48.loopexit ]
  %.64.1406 = phi i64 [ %.64.1404, %B52.lr.ph ], [ %.64.1, %B48.loopexit ]
  %.61.1405 = phi i64 [ 32, %B52.lr.ph ], [ %.61.1, %B48.loopexit ]
  %.163 = sub nsw i64 %arg.rows, %.110.sroa.0.0407
  store i64 0, ptr %.166, align 8
  %.172 = call i32 @numba.71(ptr nonnull %.166, ptr nonnull %excinfo.1, i64 32, i64 %.163)
  %.182 = load i64, ptr %.166, align 8
  switch i32 %.172, label %B52.if [
    i32 -2, label %B52.endif
    i32 0, label %B52.endif
  ]

B310:
  %.369 = sext i32 %.327 to i64
  %.370 = getelementptr double, ptr %arg.constants, i64 %.369
  %.371 = load double, ptr %.370, align 8
  store ptr null, ptr %.376, align 8
  %.380 = call i32 @fill.72(ptr nonnull %.376, ptr nonnull %excinfo.2, i64 %.182, double %.371, ptr %.352)
  switch i32 %.380, label %B310.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B380:
  %.416 = sext i32 %.327 to i64
  %.417 = getelementptr i64, ptr %arg.starts, i64 %.416
  %.418 = load i64, ptr %.417, align 8
  %.422 = getelementptr i64, ptr %arg.strides, i64 %.416
  %.423 = load i64, ptr %.422, align 8
  %.425 = mul nsw i64 %.423, %.110.sroa.0.0407
  %1 = getelementptr double, ptr %arg.given, i64 %.418
  %.428 = getelementptr double, ptr %1, i64 %.425
  store ptr null, ptr %.438, align 8
  %.442 = call i32 @pick.73(ptr nonnull %.438, ptr nonnull %excinfo.3, i64 %.182, ptr %.428, i64 %.423, ptr %.352)
  switch i32 %.442, label %B380.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B494:
  %.332 = getelementptr i8, ptr %.320, i64 12
  %.333 = load i32, ptr %.332, align 4
  %.466 = sext i32 %.327 to i64
  %.471.idx = shl nsw i64 %.466, 8
  %.471 = getelementptr i8, ptr %arg.room, i64 %.471.idx
  %.476 = sext i32 %.333 to i64
  %.479.idx = shl nsw i64 %.476, 8
  %.479 = getelementptr i8, ptr %arg.room, i64 %.479.idx
  switch i32 %.321, label %B2982 [
    i32 2, label %B612
    i32 3, label %B750
    i32 4, label %B810
    i32 5, label %B872
    i32 6, label %B934
    i32 7, label %B996
    i32 8, label %B1058
    i32 9, label %B1118
    i32 10, label %B1180
    i32 11, label %B1242
    i32 12, label %B1302
    i32 13, label %B1362
    i32 14, label %B1422
    i32 15, label %B1482
    i32 16, label %B1542
    i32 17, label %B1604
    i32 18, label %B1664
    i32 19, label %B1724
    i32 20, label %B1784
    i32 21, label %B1844
    i32 22, label %B1904
    i32 23, label %B1964
    i32 24, label %B2026
    i32 25, label %B2086
    i32 26, label %B2146
    i32 27, label %B2206
    i32 28, label %B2268
    i32 29, label %B2330
    i32 30, label %B2392
    i32 31, label %B2454
    i32 32, label %B2514
    i32 33, label %B2576
    i32 34, label %B2638
    i32 35, label %B2700
    i32 36, label %B2762
    i32 37, label %B2824
    i32 38, label %B2884
    i32 39, label %B2944
  ]

B612:
  %.499 = getelementptr i64, ptr %arg.hops, i64 %.476
  %.500 = load i64, ptr %.499, align 8
  %.504 = getelementptr i64, ptr %arg.to, i64 %.476
  %.505 = load i64, ptr %.504, align 8
  %.514 = mul nsw i64 %.500, %.110.sroa.0.0407
  %2 = getelementptr double, ptr %arg.found, i64 %.505
  %.517 = getelementptr double, ptr %2, i64 %.514
  store ptr null, ptr %.520, align 8
  %.524 = call i32 @put.74(ptr nonnull %.520, ptr nonnull %excinfo.4, i64 %.182, ptr %.471, i64 %.500, ptr %.517)
  switch i32 %.524, label %B612.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B750:
  store ptr null, ptr %.563, align 8
  %.567 = call i32 @each_same.75(ptr nonnull %.563, ptr nonnull %excinfo.5, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.567, label %B750.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B810:
  store ptr null, ptr %.605, align 8
  %.609 = call i32 @each_add.76(ptr nonnull %.605, ptr nonnull %excinfo.6, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.609, label %B810.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B872:
  store ptr null, ptr %.649, align 8
  %.653 = call i32 @each_sub.77(ptr nonnull %.649, ptr nonnull %excinfo.7, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.653, label %B872.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B934:
  store ptr null, ptr %.693, align 8
  %.697 = call i32 @each_mul.78(ptr nonnull %.693, ptr nonnull %excinfo.8, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.697, label %B934.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B996:
  store ptr null, ptr %.737, align 8
  %.741 = call i32 @each_div.79(ptr nonnull %.737, ptr nonnull %excinfo.9, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.741, label %B996.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1058:
  store ptr null, ptr %.782, align 8
  %.786 = call i32 @each_neg.80(ptr nonnull %.782, ptr nonnull %excinfo.10, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.786, label %B1058.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1118:
  store ptr null, ptr %.826, align 8
  %.830 = call i32 @each_mul.78(ptr nonnull %.826, ptr nonnull %excinfo.11, i64 %.182, ptr %.471, ptr %.471, ptr %.352)
  switch i32 %.830, label %B1118.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1180:
  store ptr null, ptr %.870, align 8
  %.874 = call i32 @each_add.76(ptr nonnull %.870, ptr nonnull %excinfo.12, i64 %.182, ptr %.471, ptr %.471, ptr %.352)
  switch i32 %.874, label %B1180.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1242:
  store ptr null, ptr %.913, align 8
  %.917 = call i32 @each_inv.81(ptr nonnull %.913, ptr nonnull %excinfo.13, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.917, label %B1242.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1302:
  store ptr null, ptr %.956, align 8
  %.960 = call i32 @each_sqrt.82(ptr nonnull %.956, ptr nonnull %excinfo.14, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.960, label %B1302.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1362:
  store ptr null, ptr %.999, align 8
  %.1003 = call i32 @each_fabs.83(ptr nonnull %.999, ptr nonnull %excinfo.15, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1003, label %B1362.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1422:
  store ptr null, ptr %.1042, align 8
  %.1046 = call i32 @each_exp.84(ptr nonnull %.1042, ptr nonnull %excinfo.16, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1046, label %B1422.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1482:
  store ptr null, ptr %.1085, align 8
  %.1089 = call i32 @each_log.85(ptr nonnull %.1085, ptr nonnull %excinfo.17, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1089, label %B1482.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1542:
  store ptr null, ptr %.1127, align 8
  %.1131 = call i32 @each_pow.86(ptr nonnull %.1127, ptr nonnull %excinfo.18, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1131, label %B1542.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1604:
  store ptr null, ptr %.1172, align 8
  %.1176 = call i32 @each_sin.87(ptr nonnull %.1172, ptr nonnull %excinfo.19, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1176, label %B1604.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1664:
  store ptr null, ptr %.1215, align 8
  %.1219 = call i32 @each_cos.88(ptr nonnull %.1215, ptr nonnull %excinfo.20, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1219, label %B1664.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1724:
  store ptr null, ptr %.1258, align 8
  %.1262 = call i32 @each_tan.89(ptr nonnull %.1258, ptr nonnull %excinfo.21, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1262, label %B1724.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1784:
  store ptr null, ptr %.1301, align 8
  %.1305 = call i32 @each_asin.90(ptr nonnull %.1301, ptr nonnull %excinfo.22, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1305, label %B1784.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1844:
  store ptr null, ptr %.1344, align 8
  %.1348 = call i32 @each_acos.91(ptr nonnull %.1344, ptr nonnull %excinfo.23, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1348, label %B1844.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1904:
  store ptr null, ptr %.1387, align 8
  %.1391 = call i32 @each_atan.92(ptr nonnull %.1387, ptr nonnull %excinfo.24, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1391, label %B1904.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1964:
  store ptr null, ptr %.1429, align 8
  %.1433 = call i32 @each_atan_of_two.93(ptr nonnull %.1429, ptr nonnull %excinfo.25, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1433, label %B1964.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2026:
  store ptr null, ptr %.1474, align 8
  %.1478 = call i32 @each_sinh.94(ptr nonnull %.1474, ptr nonnull %excinfo.26, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1478, label %B2026.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2086:
  store ptr null, ptr %.1517, align 8
  %.1521 = call i32 @each_cosh.95(ptr nonnull %.1517, ptr nonnull %excinfo.27, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1521, label %B2086.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2146:
  store ptr null, ptr %.1560, align 8
  %.1564 = call i32 @each_tanh.96(ptr nonnull %.1560, ptr nonnull %excinfo.28, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1564, label %B2146.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2206:
  store ptr null, ptr %.1602, align 8
  %.1606 = call i32 @each_less.97(ptr nonnull %.1602, ptr nonnull %excinfo.29, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1606, label %B2206.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2268:
  store ptr null, ptr %.1646, align 8
  %.1650 = call i32 @each_less_or_equal.98(ptr nonnull %.1646, ptr nonnull %excinfo.30, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1650, label %B2268.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2330:
  store ptr null, ptr %.1690, align 8
  %.1694 = call i32 @each_equal.99(ptr nonnull %.1690, ptr nonnull %excinfo.31, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1694, label %B2330.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2392:
  store ptr null, ptr %.1734, align 8
  %.1738 = call i32 @each_unequal.100(ptr nonnull %.1734, ptr nonnull %excinfo.32, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1738, label %B2392.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2454:
  store ptr null, ptr %.1779, align 8
  %.1783 = call i32 @each_not.101(ptr nonnull %.1779, ptr nonnull %excinfo.33, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1783, label %B2454.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2514:
  store ptr null, ptr %.1821, align 8
  %.1825 = call i32 @each_and.102(ptr nonnull %.1821, ptr nonnull %excinfo.34, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1825, label %B2514.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2576:
  store ptr null, ptr %.1865, align 8
  %.1869 = call i32 @each_or.103(ptr nonnull %.1865, ptr nonnull %excinfo.35, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1869, label %B2576.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2638:
  store ptr null, ptr %.1909, align 8
  %.1913 = call i32 @each_where.104(ptr nonnull %.1909, ptr nonnull %excinfo.36, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1913, label %B2638.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2700:
  store ptr null, ptr %.1953, align 8
  %.1957 = call i32 @each_smaller.105(ptr nonnull %.1953, ptr nonnull %excinfo.37, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1957, label %B2700.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2762:
  store ptr null, ptr %.1997, align 8
  %.2001 = call i32 @each_larger.106(ptr nonnull %.1997, ptr nonnull %excinfo.38, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.2001, label %B2762.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2824:
  store ptr null, ptr %.2042, align 8
  %.2046 = call i32 @each_sign.107(ptr nonnull %.2042, ptr nonnull %excinfo.39, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.2046, label %B2824.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2884:
  store ptr null, ptr %.2083, align 8
  %.2087 = call i32 @each_log_of_more.108(ptr nonnull %.2083, ptr nonnull %excinfo.40, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.2087, label %B2884.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2944:
  store ptr null, ptr %.2124, align 8
  %.2128 = call i32 @each_exp_less_one.109(ptr nonnull %.2124, ptr nonnull %excinfo.41, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.2128, label %B2944.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

common.ret:
  %common.ret.op = phi i32 [ 0, %B2982 ], [ 0, %B3004 ], [ %.2128, %B2944.if ], [ %.2087, %B2884.if ], [ %.2046, %B2824.if ], [ %.172, %B52.if ], [ %.380, %B310.if ], [ %.442, %B380.if ], [ %.524, %B612.if ], [ %.567, %B750.if ], [ %.609, %B810.if ], [ %.653, %B872.if ], [ %.697, %B934.if ], [ %.741, %B996.if ], [ %.786, %B1058.if ], [ %.830, %B1118.if ], [ %.874, %B1180.if ], [ %.917, %B1242.if ], [ %.960, %B1302.if ], [ %.1003, %B1362.if ], [ %.1046, %B1422.if ], [ %.1089, %B1482.if ], [ %.1131, %B1542.if ], [ %.1176, %B1604.if ], [ %.1219, %B1664.if ], [ %.1262, %B1724.if ], [ %.1305, %B1784.if ], [ %.1348, %B1844.if ], [ %.1391, %B1904.if ], [ %.1433, %B1964.if ], [ %.1478, %B2026.if ], [ %.1521, %B2086.if ], [ %.1564, %B2146.if ], [ %.1606, %B2206.if ], [ %.1650, %B2268.if ], [ %.1694, %B2330.if ], [ %.1738, %B2392.if ], [ %.1783, %B2454.if ], [ %.1825, %B2514.if ], [ %.1869, %B2576.if ], [ %.1913, %B2638.if ], [ %.1957, %B2700.if ], [ %.2001, %B2762.if ]
  ret i32 %common.ret.op

B2982:
  store i64 %.289, ptr %retptr, align 8
  br label %common.ret

B3004:
  store i64 0, ptr %retptr, align 8
  br label %common.ret

B3005:
  %exitcond.not = icmp eq i64 %arg.steps, %.289
  br i1 %exitcond.not, label %B48.loopexit, label %B134.if

B52.if:
  %.180 = icmp sgt i32 %.172, 0
  %.173 = load ptr, ptr %excinfo.1, align 8
  %.181 = select i1 %.180, ptr %.173, ptr undef
  store ptr %.181, ptr %excinfo, align 8
  br label %common.ret

B52.endif:
  br i1 %.276398.not, label %B48.loopexit, label %B134.if

B134.if:
  %.219.0399 = phi i64 [ %.289, %B3005 ], [ 0, %B52.endif ]
  %.289 = add nuw nsw i64 %.219.0399, 1
  %.320.idx = shl i64 %.219.0399, 4
  %.320 = getelementptr i8, ptr %arg.code, i64 %.320.idx
  %.321 = load i32, ptr %.320, align 4
  %.326 = getelementptr i8, ptr %.320, i64 8
  %.327 = load i32, ptr %.326, align 4
  %.347 = getelementptr i8, ptr %.320, i64 4
  %.348 = load i32, ptr %.347, align 4
  %.349 = sext i32 %.348 to i64
  %.352.idx = shl nsw i64 %.349, 8
  %.352 = getelementptr i8, ptr %arg.room, i64 %.352.idx
  switch i32 %.321, label %B494 [
    i32 0, label %B310
    i32 1, label %B380
  ]

B310.if:
  %.388 = icmp sgt i32 %.380, 0
  %.381 = load ptr, ptr %excinfo.2, align 8
  %.389 = select i1 %.388, ptr %.381, ptr undef
  store ptr %.389, ptr %excinfo, align 8
  br label %common.ret

B380.if:
  %.450 = icmp sgt i32 %.442, 0
  %.443 = load ptr, ptr %excinfo.3, align 8
  %.451 = select i1 %.450, ptr %.443, ptr undef
  store ptr %.451, ptr %excinfo, align 8
  br label %common.ret

B612.if:
  %.532 = icmp sgt i32 %.524, 0
  %.525 = load ptr, ptr %excinfo.4, align 8
  %.533 = select i1 %.532, ptr %.525, ptr undef
  store ptr %.533, ptr %excinfo, align 8
  br label %common.ret

B750.if:
  %.575 = icmp sgt i32 %.567, 0
  %.568 = load ptr, ptr %excinfo.5, align 8
  %.576 = select i1 %.575, ptr %.568, ptr undef
  store ptr %.576, ptr %excinfo, align 8
  br label %common.ret

B810.if:
  %.617 = icmp sgt i32 %.609, 0
  %.610 = load ptr, ptr %excinfo.6, align 8
  %.618 = select i1 %.617, ptr %.610, ptr undef
  store ptr %.618, ptr %excinfo, align 8
  br label %common.ret

B872.if:
  %.661 = icmp sgt i32 %.653, 0
  %.654 = load ptr, ptr %excinfo.7, align 8
  %.662 = select i1 %.661, ptr %.654, ptr undef
  store ptr %.662, ptr %excinfo, align 8
  br label %common.ret

B934.if:
  %.705 = icmp sgt i32 %.697, 0
  %.698 = load ptr, ptr %excinfo.8, align 8
  %.706 = select i1 %.705, ptr %.698, ptr undef
  store ptr %.706, ptr %excinfo, align 8
  br label %common.ret

B996.if:
  %.749 = icmp sgt i32 %.741, 0
  %.742 = load ptr, ptr %excinfo.9, align 8
  %.750 = select i1 %.749, ptr %.742, ptr undef
  store ptr %.750, ptr %excinfo, align 8
  br label %common.ret

B1058.if:
  %.794 = icmp sgt i32 %.786, 0
  %.787 = load ptr, ptr %excinfo.10, align 8
  %.795 = select i1 %.794, ptr %.787, ptr undef
  store ptr %.795, ptr %excinfo, align 8
  br label %common.ret

B1118.if:
  %.838 = icmp sgt i32 %.830, 0
  %.831 = load ptr, ptr %excinfo.11, align 8
  %.839 = select i1 %.838, ptr %.831, ptr undef
  store ptr %.839, ptr %excinfo, align 8
  br label %common.ret

B1180.if:
  %.882 = icmp sgt i32 %.874, 0
  %.875 = load ptr, ptr %excinfo.12, align 8
  %.883 = select i1 %.882, ptr %.875, ptr undef
  store ptr %.883, ptr %excinfo, align 8
  br label %common.ret

B1242.if:
  %.925 = icmp sgt i32 %.917, 0
  %.918 = load ptr, ptr %excinfo.13, align 8
  %.926 = select i1 %.925, ptr %.918, ptr undef
  store ptr %.926, ptr %excinfo, align 8
  br label %common.ret

B1302.if:
  %.968 = icmp sgt i32 %.960, 0
  %.961 = load ptr, ptr %excinfo.14, align 8
  %.969 = select i1 %.968, ptr %.961, ptr undef
  store ptr %.969, ptr %excinfo, align 8
  br label %common.ret

B1362.if:
  %.1011 = icmp sgt i32 %.1003, 0
  %.1004 = load ptr, ptr %excinfo.15, align 8
  %.1012 = select i1 %.1011, ptr %.1004, ptr undef
  store ptr %.1012, ptr %excinfo, align 8
  br label %common.ret

B1422.if:
  %.1054 = icmp sgt i32 %.1046, 0
  %.1047 = load ptr, ptr %excinfo.16, align 8
  %.1055 = select i1 %.1054, ptr %.1047, ptr undef
  store ptr %.1055, ptr %excinfo, align 8
  br label %common.ret

B1482.if:
  %.1097 = icmp sgt i32 %.1089, 0
  %.1090 = load ptr, ptr %excinfo.17, align 8
  %.1098 = select i1 %.1097, ptr %.1090, ptr undef
  store ptr %.1098, ptr %excinfo, align 8
  br label %common.ret

B1542.if:
  %.1139 = icmp sgt i32 %.1131, 0
  %.1132 = load ptr, ptr %excinfo.18, align 8
  %.1140 = select i1 %.1139, ptr %.1132, ptr undef
  store ptr %.1140, ptr %excinfo, align 8
  br label %common.ret

B1604.if:
  %.1184 = icmp sgt i32 %.1176, 0
  %.1177 = load ptr, ptr %excinfo.19, align 8
  %.1185 = select i1 %.1184, ptr %.1177, ptr undef
  store ptr %.1185, ptr %excinfo, align 8
  br label %common.ret

B1664.if:
  %.1227 = icmp sgt i32 %.1219, 0
  %.1220 = load ptr, ptr %excinfo.20, align 8
  %.1228 = select i1 %.1227, ptr %.1220, ptr undef
  store ptr %.1228, ptr %excinfo, align 8
  br label %common.ret

B1724.if:
  %.1270 = icmp sgt i32 %.1262, 0
  %.1263 = load ptr, ptr %excinfo.21, align 8
  %.1271 = select i1 %.1270, ptr %.1263, ptr undef
  store ptr %.1271, ptr %excinfo, align 8
  br label %common.ret

B1784.if:
  %.1313 = icmp sgt i32 %.1305, 0
  %.1306 = load ptr, ptr %excinfo.22, align 8
  %.1314 = select i1 %.1313, ptr %.1306, ptr undef
  store ptr %.1314, ptr %excinfo, align 8
  br label %common.ret

B1844.if:
  %.1356 = icmp sgt i32 %.1348, 0
  %.1349 = load ptr, ptr %excinfo.23, align 8
  %.1357 = select i1 %.1356, ptr %.1349, ptr undef
  store ptr %.1357, ptr %excinfo, align 8
  br label %common.ret

B1904.if:
  %.1399 = icmp sgt i32 %.1391, 0
  %.1392 = load ptr, ptr %excinfo.24, align 8
  %.1400 = select i1 %.1399, ptr %.1392, ptr undef
  store ptr %.1400, ptr %excinfo, align 8
  br label %common.ret

B1964.if:
  %.1441 = icmp sgt i32 %.1433, 0
  %.1434 = load ptr, ptr %excinfo.25, align 8
  %.1442 = select i1 %.1441, ptr %.1434, ptr undef
  store ptr %.1442, ptr %excinfo, align 8
  br label %common.ret

B2026.if:
  %.1486 = icmp sgt i32 %.1478, 0
  %.1479 = load ptr, ptr %excinfo.26, align 8
  %.1487 = select i1 %.1486, ptr %.1479, ptr undef
  store ptr %.1487, ptr %excinfo, align 8
  br label %common.ret

B2086.if:
  %.1529 = icmp sgt i32 %.1521, 0
  %.1522 = load ptr, ptr %excinfo.27, align 8
  %.1530 = select i1 %.1529, ptr %.1522, ptr undef
  store ptr %.1530, ptr %excinfo, align 8
  br label %common.ret

B2146.if:
  %.1572 = icmp sgt i32 %.1564, 0
  %.1565 = load ptr, ptr %excinfo.28, align 8
  %.1573 = select i1 %.1572, ptr %.1565, ptr undef
  store ptr %.1573, ptr %excinfo, align 8
  br label %common.ret

B2206.if:
  %.1614 = icmp sgt i32 %.1606, 0
  %.1607 = load ptr, ptr %excinfo.29, align 8
  %.1615 = select i1 %.1614, ptr %.1607, ptr undef
  store ptr %.1615, ptr %excinfo, align 8
  br label %common.ret

B2268.if:
  %.1658 = icmp sgt i32 %.1650, 0
  %.1651 = load ptr, ptr %excinfo.30, align 8
  %.1659 = select i1 %.1658, ptr %.1651, ptr undef
  store ptr %.1659, ptr %excinfo, align 8
  br label %common.ret

B2330.if:
  %.1702 = icmp sgt i32 %.1694, 0
  %.1695 = load ptr, ptr %excinfo.31, align 8
  %.1703 = select i1 %.1702, ptr %.1695, ptr undef
  store ptr %.1703, ptr %excinfo, align 8
  br label %common.ret

B2392.if:
  %.1746 = icmp sgt i32 %.1738, 0
  %.1739 = load ptr, ptr %excinfo.32, align 8
  %.1747 = select i1 %.1746, ptr %.1739, ptr undef
  store ptr %.1747, ptr %excinfo, align 8
  br label %common.ret

B2454.if:
  %.1791 = icmp sgt i32 %.1783, 0
  %.1784 = load ptr, ptr %excinfo.33, align 8
  %.1792 = select i1 %.1791, ptr %.1784, ptr undef
  store ptr %.1792, ptr %excinfo, align 8
  br label %common.ret

B2514.if:
  %.1833 = icmp sgt i32 %.1825, 0
  %.1826 = load ptr, ptr %excinfo.34, align 8
  %.1834 = select i1 %.1833, ptr %.1826, ptr undef
  store ptr %.1834, ptr %excinfo, align 8
  br label %common.ret

B2576.if:
  %.1877 = icmp sgt i32 %.1869, 0
  %.1870 = load ptr, ptr %excinfo.35, align 8
  %.1878 = select i1 %.1877, ptr %.1870, ptr undef
  store ptr %.1878, ptr %excinfo, align 8
  br label %common.ret

B2638.if:
  %.1921 = icmp sgt i32 %.1913, 0
  %.1914 = load ptr, ptr %excinfo.36, align 8
  %.1922 = select i1 %.1921, ptr %.1914, ptr undef
  store ptr %.1922, ptr %excinfo, align 8
  br label %common.ret

B2700.if:
  %.1965 = icmp sgt i32 %.1957, 0
  %.1958 = load ptr, ptr %excinfo.37, align 8
  %.1966 = select i1 %.1965, ptr %.1958, ptr undef
  store ptr %.1966, ptr %excinfo, align 8
  br label %common.ret

B2762.if:
  %.2009 = icmp sgt i32 %.2001, 0
  %.2002 = load ptr, ptr %excinfo.38, align 8
  %.2010 = select i1 %.2009, ptr %.2002, ptr undef
  store ptr %.2010, ptr %excinfo, align 8
  br label %common.ret

B2824.if:
  %.2054 = icmp sgt i32 %.2046, 0
  %.2047 = load ptr, ptr %excinfo.39, align 8
  %.2055 = select i1 %.2054, ptr %.2047, ptr undef
  store ptr %.2055, ptr %excinfo, align 8
  br label %common.ret

B2884.if:
  %.2095 = icmp sgt i32 %.2087, 0
  %.2088 = load ptr, ptr %excinfo.40, align 8
  %.2096 = select i1 %.2095, ptr %.2088, ptr undef
  store ptr %.2096, ptr %excinfo, align 8
  br label %common.ret

B2944.if:
  %.2136 = icmp sgt i32 %.2128, 0
  %.2129 = load ptr, ptr %excinfo.41, align 8
  %.2137 = select i1 %.2136, ptr %.2129, ptr undef
  store ptr %.2137, ptr %excinfo, align 8
  br label %common.ret
}

define internal i32 @numba.71(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.x.0, i64 %arg.x.1) {
entry:
  %.11 = call i64 @llvm.smin.i64(i64 %arg.x.1, i64 %arg.x.0)
  store i64 %.11, ptr %retptr, align 8
  ret i32 0
}

define internal i32 @fill.72(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, double %arg.value, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B50, label %B34.if

B50:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.035 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.035, 1
  %.132 = getelementptr double, ptr %arg.z, i64 %.34.035
  store double %arg.value, ptr %.132, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B50, label %B34.if
}

define internal i32 @pick.73(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, i64 %arg.stride, ptr noalias %arg.z) noinline {
entry:
  %.9535.not = icmp slt i64 %arg.n, 1
  br i1 %.9535.not, label %B68, label %B34.if

B68:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.036 = phi i64 [ %.108, %B34.if ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.036, 1
  %.134 = mul nsw i64 %.37.036, %arg.stride
  %.136 = getelementptr double, ptr %arg.x, i64 %.134
  %.137 = load double, ptr %.136, align 8
  %.139 = getelementptr double, ptr %arg.z, i64 %.37.036
  store double %.137, ptr %.139, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B68, label %B34.if
}

define internal i32 @put.74(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, i64 %arg.hop, ptr noalias %arg.z) noinline {
entry:
  %.9535.not = icmp slt i64 %arg.n, 1
  br i1 %.9535.not, label %B68, label %B34.if

B68:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.036 = phi i64 [ %.108, %B34.if ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.036, 1
  %.134 = getelementptr double, ptr %arg.x, i64 %.37.036
  %.135 = load double, ptr %.134, align 8
  %.137 = mul nsw i64 %.37.036, %arg.hop
  %.139 = getelementptr double, ptr %arg.z, i64 %.137
  store double %.135, ptr %.139, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B68, label %B34.if
}

define internal i32 @each_same.75(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B62, label %B34.if.preheader

B34.if.preheader:
  %0 = shl nuw i64 %arg.n, 3
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %arg.z, ptr align 8 %arg.x, i64 %0, i1 false)
  br label %B62

B62:
  store ptr null, ptr %retptr, align 8
  ret i32 0
}

define internal i32 @each_add.76(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
entry:
  %.9534.not = icmp slt i64 %arg.n, 1
  br i1 %.9534.not, label %B80, label %B34.if

B80:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.035 = phi i64 [ %.108, %B34.if ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.035, 1
  %.134 = getelementptr double, ptr %arg.x, i64 %.37.035
  %.135 = load double, ptr %.134, align 8
  %.137 = getelementptr double, ptr %arg.y, i64 %.37.035
  %.138 = load double, ptr %.137, align 8
  %.139 = fadd contract double %.135, %.138
  %.141 = getelementptr double, ptr %arg.z, i64 %.37.035
  store double %.139, ptr %.141, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B80, label %B34.if
}

define internal i32 @each_sub.77(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
entry:
  %.9534.not = icmp slt i64 %arg.n, 1
  br i1 %.9534.not, label %B80, label %B34.if

B80:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.035 = phi i64 [ %.108, %B34.if ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.035, 1
  %.134 = getelementptr double, ptr %arg.x, i64 %.37.035
  %.135 = load double, ptr %.134, align 8
  %.137 = getelementptr double, ptr %arg.y, i64 %.37.035
  %.138 = load double, ptr %.137, align 8
  %.139 = fsub contract double %.135, %.138
  %.141 = getelementptr double, ptr %arg.z, i64 %.37.035
  store double %.139, ptr %.141, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B80, label %B34.if
}

define internal i32 @each_mul.78(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
entry:
  %.9534.not = icmp slt i64 %arg.n, 1
  br i1 %.9534.not, label %B80, label %B34.if

B80:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.035 = phi i64 [ %.108, %B34.if ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.035, 1
  %.134 = getelementptr double, ptr %arg.x, i64 %.37.035
  %.135 = load double, ptr %.134, align 8
  %.137 = getelementptr double, ptr %arg.y, i64 %.37.035
  %.138 = load double, ptr %.137, align 8
  %.139 = fmul contract double %.135, %.138
  %.141 = getelementptr double, ptr %arg.z, i64 %.37.035
  store double %.139, ptr %.141, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B80, label %B34.if
}

define internal i32 @each_div.79(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
entry:
  %.9534.not = icmp slt i64 %arg.n, 1
  br i1 %.9534.not, label %B80, label %B34.if

B80:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.035 = phi i64 [ %.108, %B34.if ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.035, 1
  %.134 = getelementptr double, ptr %arg.x, i64 %.37.035
  %.135 = load double, ptr %.134, align 8
  %.137 = getelementptr double, ptr %arg.y, i64 %.37.035
  %.138 = load double, ptr %.137, align 8
  %.142 = fdiv contract double %.135, %.138
  %.144 = getelementptr double, ptr %arg.z, i64 %.37.035
  store double %.142, ptr %.144, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B80, label %B34.if
}

define internal i32 @each_neg.80(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B64, label %B34.if

B64:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.035 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.035, 1
  %.131 = getelementptr double, ptr %arg.x, i64 %.34.035
  %.132 = load double, ptr %.131, align 8
  %.133 = fneg contract double %.132
  %.135 = getelementptr double, ptr %arg.z, i64 %.34.035
  store double %.133, ptr %.135, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B64, label %B34.if
}

define internal i32 @each_inv.81(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B68, label %B34.if

B68:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.035 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.035, 1
  %.131 = getelementptr double, ptr %arg.x, i64 %.34.035
  %.132 = load double, ptr %.131, align 8
  %.136 = fdiv contract double 1.000000e+00, %.132
  %.138 = getelementptr double, ptr %arg.z, i64 %.34.035
  store double %.136, ptr %.138, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B68, label %B34.if
}

define internal i32 @each_sqrt.82(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B98, label %B34.if

B98:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.035 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.035, 1
  %.131 = getelementptr double, ptr %arg.x, i64 %.34.035
  %.132 = load double, ptr %.131, align 8
  %.133 = call contract double @sqrt(double %.132)
  %.135 = getelementptr double, ptr %arg.z, i64 %.34.035
  store double %.133, ptr %.135, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B98, label %B34.if
}

define internal i32 @each_fabs.83(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B98, label %B34.if

B98:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.035 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.035, 1
  %.131 = getelementptr double, ptr %arg.x, i64 %.34.035
  %.132 = load double, ptr %.131, align 8
  %.133 = call contract double @llvm.fabs.f64(double %.132)
  %.135 = getelementptr double, ptr %arg.z, i64 %.34.035
  store double %.133, ptr %.135, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B98, label %B34.if
}

define internal i32 @each_exp.84(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B98, label %B34.if

B98:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.035 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.035, 1
  %.131 = getelementptr double, ptr %arg.x, i64 %.34.035
  %.132 = load double, ptr %.131, align 8
  %.133 = call contract double @llvm.exp.f64(double %.132)
  %.135 = getelementptr double, ptr %arg.z, i64 %.34.035
  store double %.133, ptr %.135, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B98, label %B34.if
}

define internal i32 @each_log.85(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B98, label %B34.if

B98:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.035 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.035, 1
  %.131 = getelementptr double, ptr %arg.x, i64 %.34.035
  %.132 = load double, ptr %.131, align 8
  %.133 = call contract double @llvm.log.f64(double %.132)
  %.135 = getelementptr double, ptr %arg.z, i64 %.34.035
  store double %.133, ptr %.135, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B98, label %B34.if
}

define internal i32 @each_pow.86(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
entry:
  %.9534.not = icmp slt i64 %arg.n, 1
  br i1 %.9534.not, label %B112, label %B34.if

B112:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.035 = phi i64 [ %.108, %B34.if ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.035, 1
  %.134 = getelementptr double, ptr %arg.x, i64 %.37.035
  %.135 = load double, ptr %.134, align 8
  %.137 = getelementptr double, ptr %arg.y, i64 %.37.035
  %.138 = load double, ptr %.137, align 8
  %.139 = call contract double @llvm.pow.f64(double %.135, double %.138)
  %.141 = getelementptr double, ptr %arg.z, i64 %.37.035
  store double %.139, ptr %.141, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B112, label %B34.if
}

define internal i32 @each_sin.87(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B98, label %B34.if

B98:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.035 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.035, 1
  %.131 = getelementptr double, ptr %arg.x, i64 %.34.035
  %.132 = load double, ptr %.131, align 8
  %.133 = call contract double @llvm.sin.f64(double %.132)
  %.135 = getelementptr double, ptr %arg.z, i64 %.34.035
  store double %.133, ptr %.135, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B98, label %B34.if
}

define internal i32 @each_cos.88(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B98, label %B34.if

B98:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.035 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.035, 1
  %.131 = getelementptr double, ptr %arg.x, i64 %.34.035
  %.132 = load double, ptr %.131, align 8
  %.133 = call contract double @llvm.cos.f64(double %.132)
  %.135 = getelementptr double, ptr %arg.z, i64 %.34.035
  store double %.133, ptr %.135, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B98, label %B34.if
}

define internal i32 @each_tan.89(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B98, label %B34.if

B98:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.035 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.035, 1
  %.131 = getelementptr double, ptr %arg.x, i64 %.34.035
  %.132 = load double, ptr %.131, align 8
  %.133 = call contract double @tan(double %.132)
  %.135 = getelementptr double, ptr %arg.z, i64 %.34.035
  store double %.133, ptr %.135, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B98, label %B34.if
}

define internal i32 @each_asin.90(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B98, label %B34.if

B98:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.035 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.035, 1
  %.131 = getelementptr double, ptr %arg.x, i64 %.34.035
  %.132 = load double, ptr %.131, align 8
  %.133 = call contract double @asin(double %.132)
  %.135 = getelementptr double, ptr %arg.z, i64 %.34.035
  store double %.133, ptr %.135, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B98, label %B34.if
}

define internal i32 @each_acos.91(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B98, label %B34.if

B98:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.035 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.035, 1
  %.131 = getelementptr double, ptr %arg.x, i64 %.34.035
  %.132 = load double, ptr %.131, align 8
  %.133 = call contract double @acos(double %.132)
  %.135 = getelementptr double, ptr %arg.z, i64 %.34.035
  store double %.133, ptr %.135, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B98, label %B34.if
}

define internal i32 @each_atan.92(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B98, label %B34.if

B98:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.035 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.035, 1
  %.131 = getelementptr double, ptr %arg.x, i64 %.34.035
  %.132 = load double, ptr %.131, align 8
  %.133 = call contract double @atan(double %.132)
  %.135 = getelementptr double, ptr %arg.z, i64 %.34.035
  store double %.133, ptr %.135, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B98, label %B34.if
}

define internal i32 @each_atan_of_two.93(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
entry:
  %.9534.not = icmp slt i64 %arg.n, 1
  br i1 %.9534.not, label %B112, label %B34.if

B112:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.035 = phi i64 [ %.108, %B34.if ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.035, 1
  %.134 = getelementptr double, ptr %arg.x, i64 %.37.035
  %.135 = load double, ptr %.134, align 8
  %.137 = getelementptr double, ptr %arg.y, i64 %.37.035
  %.138 = load double, ptr %.137, align 8
  %.139 = call contract double @atan2(double %.135, double %.138)
  %.141 = getelementptr double, ptr %arg.z, i64 %.37.035
  store double %.139, ptr %.141, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B112, label %B34.if
}

define internal i32 @each_sinh.94(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B98, label %B34.if

B98:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.035 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.035, 1
  %.131 = getelementptr double, ptr %arg.x, i64 %.34.035
  %.132 = load double, ptr %.131, align 8
  %.133 = call contract double @sinh(double %.132)
  %.135 = getelementptr double, ptr %arg.z, i64 %.34.035
  store double %.133, ptr %.135, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B98, label %B34.if
}

define internal i32 @each_cosh.95(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B98, label %B34.if

B98:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.035 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.035, 1
  %.131 = getelementptr double, ptr %arg.x, i64 %.34.035
  %.132 = load double, ptr %.131, align 8
  %.133 = call contract double @cosh(double %.132)
  %.135 = getelementptr double, ptr %arg.z, i64 %.34.035
  store double %.133, ptr %.135, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B98, label %B34.if
}

define internal i32 @each_tanh.96(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B98, label %B34.if

B98:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.035 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.035, 1
  %.131 = getelementptr double, ptr %arg.x, i64 %.34.035
  %.132 = load double, ptr %.131, align 8
  %.133 = call contract double @tanh(double %.132)
  %.135 = getelementptr double, ptr %arg.z, i64 %.34.035
  store double %.133, ptr %.135, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B98, label %B34.if
}

define internal i32 @each_less.97(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
entry:
  %.9538.not = icmp slt i64 %arg.n, 1
  br i1 %.9538.not, label %B90, label %B34.if

B90:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.039 = phi i64 [ %.108, %B34.if ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.039, 1
  %.138 = getelementptr double, ptr %arg.x, i64 %.37.039
  %.139 = load double, ptr %.138, align 8
  %.142 = getelementptr double, ptr %arg.y, i64 %.37.039
  %.143 = load double, ptr %.142, align 8
  %.144 = fcmp contract olt double %.139, %.143
  %. = select i1 %.144, double 1.000000e+00, double 0.000000e+00
  %.156 = getelementptr double, ptr %arg.z, i64 %.37.039
  store double %., ptr %.156, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B90, label %B34.if
}

define internal i32 @each_less_or_equal.98(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
entry:
  %.9538.not = icmp slt i64 %arg.n, 1
  br i1 %.9538.not, label %B90, label %B34.if

B90:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.039 = phi i64 [ %.108, %B34.if ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.039, 1
  %.138 = getelementptr double, ptr %arg.x, i64 %.37.039
  %.139 = load double, ptr %.138, align 8
  %.142 = getelementptr double, ptr %arg.y, i64 %.37.039
  %.143 = load double, ptr %.142, align 8
  %.144 = fcmp contract ugt double %.139, %.143
  %. = select i1 %.144, double 0.000000e+00, double 1.000000e+00
  %.156 = getelementptr double, ptr %arg.z, i64 %.37.039
  store double %., ptr %.156, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B90, label %B34.if
}

define internal i32 @each_equal.99(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
entry:
  %.9538.not = icmp slt i64 %arg.n, 1
  br i1 %.9538.not, label %B90, label %B34.if

B90:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.039 = phi i64 [ %.108, %B34.if ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.039, 1
  %.138 = getelementptr double, ptr %arg.x, i64 %.37.039
  %.139 = load double, ptr %.138, align 8
  %.142 = getelementptr double, ptr %arg.y, i64 %.37.039
  %.143 = load double, ptr %.142, align 8
  %.144 = fcmp contract oeq double %.139, %.143
  %. = select i1 %.144, double 1.000000e+00, double 0.000000e+00
  %.156 = getelementptr double, ptr %arg.z, i64 %.37.039
  store double %., ptr %.156, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B90, label %B34.if
}

define internal i32 @each_unequal.100(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
entry:
  %.9538.not = icmp slt i64 %arg.n, 1
  br i1 %.9538.not, label %B90, label %B34.if

B90:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.039 = phi i64 [ %.108, %B34.if ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.039, 1
  %.138 = getelementptr double, ptr %arg.x, i64 %.37.039
  %.139 = load double, ptr %.138, align 8
  %.142 = getelementptr double, ptr %arg.y, i64 %.37.039
  %.143 = load double, ptr %.142, align 8
  %.144 = fcmp contract une double %.139, %.143
  %. = select i1 %.144, double 1.000000e+00, double 0.000000e+00
  %.156 = getelementptr double, ptr %arg.z, i64 %.37.039
  store double %., ptr %.156, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B90, label %B34.if
}

define internal i32 @each_not.101(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9237.not = icmp slt i64 %arg.n, 1
  br i1 %.9237.not, label %B78, label %B34.if

B78:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.038 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.038, 1
  %.135 = getelementptr double, ptr %arg.x, i64 %.34.038
  %.136 = load double, ptr %.135, align 8
  %.137 = fcmp contract oeq double %.136, 0.000000e+00
  %. = select i1 %.137, double 1.000000e+00, double 0.000000e+00
  %.149 = getelementptr double, ptr %arg.z, i64 %.34.038
  store double %., ptr %.149, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B78, label %B34.if
}

define internal i32 @each_and.102(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
entry:
  %.9538.not = icmp slt i64 %arg.n, 1
  br i1 %.9538.not, label %B102, label %B34.if

B62:
  %.144 = getelementptr double, ptr %arg.y, i64 %.37.039
  %.145 = load double, ptr %.144, align 8
  %.146 = fcmp contract une double %.145, 0.000000e+00
  br i1 %.146, label %B92, label %B90

B90:
  br label %B92

B92:
  %"$phi92.1.2.1" = phi double [ 0.000000e+00, %B90 ], [ 1.000000e+00, %B62 ]
  %.158 = getelementptr double, ptr %arg.z, i64 %.37.039
  store double %"$phi92.1.2.1", ptr %.158, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B102, label %B34.if

B102:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.039 = phi i64 [ %.108, %B92 ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.039, 1
  %.138 = getelementptr double, ptr %arg.x, i64 %.37.039
  %.139 = load double, ptr %.138, align 8
  %.140 = fcmp contract une double %.139, 0.000000e+00
  br i1 %.140, label %B62, label %B90
}

define internal i32 @each_or.103(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
entry:
  %.9538.not = icmp slt i64 %arg.n, 1
  br i1 %.9538.not, label %B102, label %B34.if

B62:
  %.144 = getelementptr double, ptr %arg.y, i64 %.37.039
  %.145 = load double, ptr %.144, align 8
  %.146 = fcmp contract une double %.145, 0.000000e+00
  br i1 %.146, label %B92, label %B90

B90:
  br label %B92

B92:
  %"$phi92.1.2.1" = phi double [ 0.000000e+00, %B90 ], [ 1.000000e+00, %B62 ], [ 1.000000e+00, %B34.if ]
  %.158 = getelementptr double, ptr %arg.z, i64 %.37.039
  store double %"$phi92.1.2.1", ptr %.158, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B102, label %B34.if

B102:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.039 = phi i64 [ %.108, %B92 ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.039, 1
  %.138 = getelementptr double, ptr %arg.x, i64 %.37.039
  %.139 = load double, ptr %.138, align 8
  %.140 = fcmp contract une double %.139, 0.000000e+00
  br i1 %.140, label %B92, label %B62
}

define internal i32 @each_where.104(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
entry:
  %.9538.not = icmp slt i64 %arg.n, 1
  br i1 %.9538.not, label %B90, label %B34.if

B62:
  %.144 = getelementptr double, ptr %arg.y, i64 %.37.039
  %.145 = load double, ptr %.144, align 8
  br label %B80

B80:
  %"$phi80.1.2.1" = phi double [ %.145, %B62 ], [ 0.000000e+00, %B34.if ]
  %.156 = getelementptr double, ptr %arg.z, i64 %.37.039
  store double %"$phi80.1.2.1", ptr %.156, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B90, label %B34.if

B90:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.039 = phi i64 [ %.108, %B80 ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.039, 1
  %.138 = getelementptr double, ptr %arg.x, i64 %.37.039
  %.139 = load double, ptr %.138, align 8
  %.140 = fcmp contract une double %.139, 0.000000e+00
  br i1 %.140, label %B62, label %B80
}

define internal i32 @each_smaller.105(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
entry:
  %.9542.not = icmp slt i64 %arg.n, 1
  br i1 %.9542.not, label %B150, label %B34.if

B150:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.043 = phi i64 [ %.108, %B34.if ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.043, 1
  %.138 = getelementptr double, ptr %arg.x, i64 %.37.043
  %.139 = load double, ptr %.138, align 8
  %.142 = getelementptr double, ptr %arg.y, i64 %.37.043
  %.143 = load double, ptr %.142, align 8
  %.144 = fcmp contract ole double %.139, %.143
  %.154 = fcmp contract uno double %.143, 0.000000e+00
  %or.cond = or i1 %.144, %.154
  %"$phi140.1.2.1" = select i1 %or.cond, double %.139, double %.143
  %.174 = getelementptr double, ptr %arg.z, i64 %.37.043
  store double %"$phi140.1.2.1", ptr %.174, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B150, label %B34.if
}

define internal i32 @each_larger.106(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
entry:
  %.9542.not = icmp slt i64 %arg.n, 1
  br i1 %.9542.not, label %B150, label %B34.if

B150:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.37.043 = phi i64 [ %.108, %B34.if ], [ 0, %entry ]
  %.108 = add nuw nsw i64 %.37.043, 1
  %.138 = getelementptr double, ptr %arg.x, i64 %.37.043
  %.139 = load double, ptr %.138, align 8
  %.142 = getelementptr double, ptr %arg.y, i64 %.37.043
  %.143 = load double, ptr %.142, align 8
  %.144 = fcmp contract oge double %.139, %.143
  %.154 = fcmp contract uno double %.143, 0.000000e+00
  %or.cond = or i1 %.144, %.154
  %"$phi140.1.2.1" = select i1 %or.cond, double %.139, double %.143
  %.174 = getelementptr double, ptr %arg.z, i64 %.37.043
  store double %"$phi140.1.2.1", ptr %.174, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B150, label %B34.if
}

define internal i32 @each_sign.107(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9239.not = icmp slt i64 %arg.n, 1
  br i1 %.9239.not, label %B118, label %B34.if

B118:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.040 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.040, 1
  %.135 = getelementptr double, ptr %arg.x, i64 %.34.040
  %.136 = load double, ptr %.135, align 8
  %.137 = fcmp contract ogt double %.136, 0.000000e+00
  %.147 = fcmp contract olt double %.136, 0.000000e+00
  %..136 = select i1 %.147, double -1.000000e+00, double %.136
  %"$phi108.1.3.1" = select i1 %.137, double 1.000000e+00, double %..136
  %.162 = getelementptr double, ptr %arg.z, i64 %.34.040
  store double %"$phi108.1.3.1", ptr %.162, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B118, label %B34.if
}

define internal i32 @each_log_of_more.108(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B98, label %B34.if

B98:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.035 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.035, 1
  %.131 = getelementptr double, ptr %arg.x, i64 %.34.035
  %.132 = load double, ptr %.131, align 8
  %.133 = call contract double @log1p(double %.132)
  %.135 = getelementptr double, ptr %arg.z, i64 %.34.035
  store double %.133, ptr %.135, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B98, label %B34.if
}

define internal i32 @each_exp_less_one.109(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
entry:
  %.9234.not = icmp slt i64 %arg.n, 1
  br i1 %.9234.not, label %B98, label %B34.if

B98:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.34.035 = phi i64 [ %.105, %B34.if ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.035, 1
  %.131 = getelementptr double, ptr %arg.x, i64 %.34.035
  %.132 = load double, ptr %.131, align 8
  %.133 = call contract double @expm1(double %.132)
  %.135 = getelementptr double, ptr %arg.z, i64 %.34.035
  store double %.133, ptr %.135, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B98, label %B34.if
}

declare double @expm1(double)

declare double @log1p(double)

declare double @tanh(double)

declare double @cosh(double)

declare double @sinh(double)

declare double @atan2(double, double)

declare double @atan(double)

declare double @acos(double)

declare double @asin(double)

declare double @tan(double)

declare double @llvm.cos.f64(double)

declare double @llvm.sin.f64(double)

declare double @llvm.log.f64(double)

declare double @llvm.exp.f64(double)

declare double @sqrt(double)

define i64 @follow(i64 %a0, i64 %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @follow.110(ptr nonnull %r, ptr nonnull %e, i64 %a0, i64 %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8)
  ret i64 0
}

define internal i32 @follow.110(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.steps, i64 %arg.count, i64 %arg.channels, ptr noalias %arg.step, ptr noalias %arg.rate, ptr noalias %arg.growth, ptr noalias %arg.drive, ptr noalias %arg.state, ptr noalias %arg.found) noinline {
entry:
  %.33 = mul nsw i64 %arg.channels, %arg.count
  %.119167.not = icmp slt i64 %.33, 1
  br i1 %.119167.not, label %B72, label %B44.if.preheader

B44.if.preheader:
  %0 = shl nuw i64 %.33, 3
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %arg.found, ptr align 8 %arg.state, i64 %0, i1 false)
  br label %B72

B72:
  %.251176.not = icmp slt i64 %arg.steps, 1
  br i1 %.251176.not, label %B734, label %B104.if.lr.ph

B104.if.lr.ph:
  %.386173.not = icmp slt i64 %arg.count, 1
  %storemerge166 = call i64 @llvm.smax.i64(i64 %arg.channels, i64 0)
  %.688170.not = icmp slt i64 %arg.channels, 1
  br label %B104.if

B102.loopexit:
  %exitcond179.not = icmp eq i64 %.264, %arg.steps
  br i1 %exitcond179.not, label %B734, label %B104.if

B164.loopexit:
  %exitcond.not = icmp eq i64 %arg.count, %.399
  br i1 %exitcond.not, label %B102.loopexit, label %B166.if

B280:
  %.459 = fmul contract double %.435, 5.000000e-01
  %.465 = fdiv contract double %.435, 3.000000e+00
  %.471 = fmul contract double %.435, 2.500000e-01
  %.477 = fdiv contract double %.435, 5.000000e+00
  %.483 = fdiv contract double %.435, 6.000000e+00
  %.485 = fadd contract double %.483, 1.000000e+00
  %.486 = fmul contract double %.477, %.485
  %.488 = fadd contract double %.486, 1.000000e+00
  %.489 = fmul contract double %.471, %.488
  %.491 = fadd contract double %.489, 1.000000e+00
  %.492 = fmul contract double %.465, %.491
  %.494 = fadd contract double %.492, 1.000000e+00
  %.495 = fmul contract double %.459, %.494
  %.497 = fadd contract double %.495, 1.000000e+00
  %.530 = fdiv contract double %.435, 7.000000e+00
  %.534 = fadd contract double %.530, 1.000000e+00
  %.535 = fmul contract double %.483, %.534
  %.537 = fadd contract double %.535, 1.000000e+00
  %.538 = fmul contract double %.477, %.537
  %.540 = fadd contract double %.538, 1.000000e+00
  %.541 = fmul contract double %.471, %.540
  %.543 = fadd contract double %.541, 1.000000e+00
  %.544 = fmul contract double %.465, %.543
  %.546 = fadd contract double %.544, 1.000000e+00
  %.551 = fmul contract double %.546, 5.000000e-01
  br label %B496

B464:
  %.558 = fadd contract double %.443, -1.000000e+00
  %.563 = fdiv contract double %.558, %.435
  %.567 = fadd contract double %.563, -1.000000e+00
  %.572 = fdiv contract double %.567, %.435
  br label %B496

B496:
  %level.3.2 = phi double [ %.497, %B280 ], [ %.563, %B464 ]
  %ramp.3.2 = phi double [ %.551, %B280 ], [ %.572, %B464 ]
  %.583 = fmul contract double %.430, %level.3.2
  %.591 = fmul contract double %.430, %ramp.3.2
  br i1 %.688170.not, label %B164.loopexit, label %B590.if.preheader

B590.if.preheader:
  %.602 = mul nuw nsw i64 %.329.0174, %arg.channels
  br label %B590.if

B734:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B104.if:
  %.194.0177 = phi i64 [ 0, %B104.if.lr.ph ], [ %.264, %B102.loopexit ]
  %.264 = add nuw nsw i64 %.194.0177, 1
  %.298 = mul nsw i64 %.264, %.33
  br i1 %.386173.not, label %B102.loopexit, label %B166.if.lr.ph

B166.if.lr.ph:
  %.294 = mul nsw i64 %.194.0177, %.33
  %.429 = getelementptr double, ptr %arg.step, i64 %.194.0177
  %.430 = load double, ptr %.429, align 8
  %.438 = mul nuw nsw i64 %.194.0177, %arg.count
  %1 = getelementptr double, ptr %arg.growth, i64 %.438
  %2 = getelementptr double, ptr %arg.drive, i64 %.294
  br label %B166.if

B166.if:
  %.329.0174 = phi i64 [ 0, %B166.if.lr.ph ], [ %.399, %B164.loopexit ]
  %.399 = add nuw nsw i64 %.329.0174, 1
  %.433 = getelementptr double, ptr %arg.rate, i64 %.329.0174
  %.434 = load double, ptr %.433, align 8
  %.435 = fmul contract double %.430, %.434
  %.442 = getelementptr double, ptr %1, i64 %.329.0174
  %.443 = load double, ptr %.442, align 8
  %.451 = call contract double @llvm.fabs.f64(double %.435)
  %.452 = fcmp contract olt double %.451, 1.000000e-02
  br i1 %.452, label %B280, label %B464

B590.if:
  %.635.0172 = phi i64 [ %.697, %B590.if ], [ %storemerge166, %B590.if.preheader ]
  %.632.0171 = phi i64 [ %.701, %B590.if ], [ %.602, %B590.if.preheader ]
  %.697 = add nsw i64 %.635.0172, -1
  %.701 = add i64 %.632.0171, 1
  %.729 = getelementptr double, ptr %2, i64 %.632.0171
  %.730 = load double, ptr %.729, align 8
  %.732 = fmul contract double %.583, %.730
  %.734 = add nsw i64 %.632.0171, %.298
  %.736 = getelementptr double, ptr %arg.drive, i64 %.734
  %.737 = load double, ptr %.736, align 8
  %.738 = fsub contract double %.737, %.730
  %.740 = fmul contract double %.591, %.738
  %.741 = fadd contract double %.732, %.740
  %.743 = getelementptr double, ptr %arg.state, i64 %.632.0171
  %.744 = load double, ptr %.743, align 8
  %.746 = fmul contract double %.443, %.744
  %.747 = fadd contract double %.746, %.741
  store double %.747, ptr %.743, align 8
  %.757 = getelementptr double, ptr %arg.found, i64 %.734
  store double %.747, ptr %.757, align 8
  %.688 = icmp sgt i64 %.635.0172, 1
  br i1 %.688, label %B590.if, label %B164.loopexit
}

define i64 @follow_turning(i64 %a0, i64 %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @follow_turning.111(ptr nonnull %r, ptr nonnull %e, i64 %a0, i64 %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8)
  ret i64 0
}

define internal i32 @follow_turning.111(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.steps, i64 %arg.count, i64 %arg.channels, ptr noalias %arg.step, ptr noalias %arg.rate, ptr noalias %arg.growth, ptr noalias %arg.drive, ptr noalias %arg.state, ptr noalias %arg.found) noinline {
entry:
  %.33 = mul nsw i64 %arg.channels, %arg.count
  %0 = call i64 @llvm.smax.i64(i64 %.33, i64 0)
  %storemerge = shl nuw i64 %0, 1
  %.120209 = icmp sgt i64 %storemerge, 0
  br i1 %.120209, label %B50.if.preheader, label %B78

B50.if.preheader:
  %1 = shl i64 %0, 4
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %arg.found, ptr align 8 %arg.state, i64 %1, i1 false)
  br label %B78

B78:
  %.252224.not = icmp slt i64 %arg.steps, 1
  br i1 %.252224.not, label %B1216, label %B110.if.lr.ph

B110.if.lr.ph:
  %.387221.not = icmp slt i64 %arg.count, 1
  %storemerge208 = call i64 @llvm.smax.i64(i64 %arg.channels, i64 0)
  %.931218.not = icmp slt i64 %arg.channels, 1
  br label %B110.if

B108.loopexit:
  %exitcond227.not = icmp eq i64 %.265, %arg.steps
  br i1 %exitcond227.not, label %B1216, label %B110.if

B170.loopexit:
  %exitcond.not = icmp eq i64 %arg.count, %.400
  br i1 %exitcond.not, label %B108.loopexit, label %B172.if

B586:
  %.721 = fmul contract double %.677, 5.000000e-01
  %.729 = fmul contract double %.690, 5.000000e-01
  br label %B742

B608:
  %.744 = fdiv contract double %.437, %.486
  %.748 = fneg contract double %.448
  %.755 = fdiv contract double %.748, %.486
  %.760 = fadd contract double %.463, -1.000000e+00
  %.761 = fmul contract double %.760, %.744
  %.763 = fmul contract double %.473, %.755
  %.764 = fsub contract double %.761, %.763
  %.768 = fmul contract double %.760, %.755
  %.770 = fmul contract double %.473, %.744
  %.771 = fadd contract double %.768, %.770
  %.777 = fadd contract double %.764, -1.000000e+00
  %.778 = fmul contract double %.744, %.777
  %.779 = fmul contract double %.755, %.771
  %.780 = fsub contract double %.778, %.779
  %.783 = fmul contract double %.755, %.777
  %.784 = fmul contract double %.744, %.771
  %.785 = fadd contract double %.784, %.783
  br label %B742

B742:
  %lr.5.2 = phi double [ %.646, %B586 ], [ %.764, %B608 ]
  %li.5.2 = phi double [ %.658, %B586 ], [ %.771, %B608 ]
  %ri.6.2 = phi double [ %.729, %B586 ], [ %.785, %B608 ]
  %rr.6.2 = phi double [ %.721, %B586 ], [ %.780, %B608 ]
  %.796 = fmul contract double %.431, %lr.5.2
  %.804 = fmul contract double %.431, %li.5.2
  %.812 = fmul contract double %.431, %rr.6.2
  %.820 = fmul contract double %.431, %ri.6.2
  br i1 %.931218.not, label %B170.loopexit, label %B886.if.preheader

B886.if.preheader:
  %.845 = mul nuw nsw i64 %.330.0222, %arg.channels
  br label %B886.if

B1216:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B110.if:
  %.195.0225 = phi i64 [ 0, %B110.if.lr.ph ], [ %.265, %B108.loopexit ]
  %.265 = add nuw nsw i64 %.195.0225, 1
  %.299 = mul nsw i64 %.265, %.33
  br i1 %.387221.not, label %B108.loopexit, label %B172.if.lr.ph

B172.if.lr.ph:
  %.295 = mul nsw i64 %.195.0225, %.33
  %.430 = getelementptr double, ptr %arg.step, i64 %.195.0225
  %.431 = load double, ptr %.430, align 8
  %.457 = mul nuw nsw i64 %.195.0225, %arg.count
  %2 = getelementptr double, ptr %arg.drive, i64 %.295
  br label %B172.if

B172.if:
  %.330.0222 = phi i64 [ 0, %B172.if.lr.ph ], [ %.400, %B170.loopexit ]
  %.400 = add nuw nsw i64 %.330.0222, 1
  %.435.idx = shl i64 %.330.0222, 4
  %.435 = getelementptr i8, ptr %arg.rate, i64 %.435.idx
  %.436 = load double, ptr %.435, align 8
  %.437 = fmul contract double %.431, %.436
  %.446 = getelementptr i8, ptr %.435, i64 8
  %.447 = load double, ptr %.446, align 8
  %.448 = fmul contract double %.431, %.447
  %.459 = add nuw nsw i64 %.330.0222, %.457
  %.462.idx = shl i64 %.459, 4
  %.462 = getelementptr i8, ptr %arg.growth, i64 %.462.idx
  %.463 = load double, ptr %.462, align 8
  %.472 = getelementptr i8, ptr %.462, i64 8
  %.473 = load double, ptr %.472, align 8
  %.482 = fmul contract double %.437, %.437
  %.485 = fmul contract double %.448, %.448
  %.486 = fadd contract double %.482, %.485
  %.492 = fcmp contract olt double %.486, 1.000000e-04
  br i1 %.492, label %B444.if, label %B608

B444.if:
  %ri.5.2217 = phi double [ %.690, %B444.if ], [ 0.000000e+00, %B172.if ]
  %rr.5.2216 = phi double [ %.677, %B444.if ], [ 1.000000e+00, %B172.if ]
  %li.4.2215 = phi double [ %.658, %B444.if ], [ 0.000000e+00, %B172.if ]
  %lr.4.2214 = phi double [ %.646, %B444.if ], [ 1.000000e+00, %B172.if ]
  %.542.0213 = phi i64 [ %.604, %B444.if ], [ 5, %B172.if ]
  %.539.0212 = phi i64 [ %.608, %B444.if ], [ 6, %B172.if ]
  %.604 = add nsw i64 %.542.0213, -1
  %.608 = add nsw i64 %.539.0212, -1
  %.635 = fmul contract double %.437, %lr.4.2214
  %.638 = fmul contract double %.448, %li.4.2215
  %.639 = fsub contract double %.635, %.638
  %.640 = sitofp i64 %.539.0212 to double
  %.644 = fdiv contract double %.639, %.640
  %.646 = fadd contract double %.644, 1.000000e+00
  %.649 = fmul contract double %.437, %li.4.2215
  %.652 = fmul contract double %.448, %lr.4.2214
  %.653 = fadd contract double %.652, %.649
  %.658 = fdiv contract double %.653, %.640
  %.665 = fmul contract double %.437, %rr.5.2216
  %.668 = fmul contract double %.448, %ri.5.2217
  %.669 = fsub contract double %.665, %.668
  %.670 = add nuw nsw i64 %.539.0212, 1
  %.671 = sitofp i64 %.670 to double
  %.675 = fdiv contract double %.669, %.671
  %.677 = fadd contract double %.675, 1.000000e+00
  %.680 = fmul contract double %.437, %ri.5.2217
  %.683 = fmul contract double %.448, %rr.5.2216
  %.684 = fadd contract double %.683, %.680
  %.690 = fdiv contract double %.684, %.671
  %.595 = icmp samesign ugt i64 %.542.0213, 1
  br i1 %.595, label %B444.if, label %B586

B886.if:
  %.878.0220 = phi i64 [ %.940, %B886.if ], [ %storemerge208, %B886.if.preheader ]
  %.875.0219 = phi i64 [ %.944, %B886.if ], [ %.845, %B886.if.preheader ]
  %.940 = add nsw i64 %.878.0220, -1
  %.944 = add i64 %.875.0219, 1
  %.972 = getelementptr double, ptr %2, i64 %.875.0219
  %.973 = load double, ptr %.972, align 8
  %.975 = add nsw i64 %.875.0219, %.299
  %.977 = getelementptr double, ptr %arg.drive, i64 %.975
  %.978 = load double, ptr %.977, align 8
  %.979 = fsub contract double %.978, %.973
  %.982.idx = shl i64 %.875.0219, 4
  %.982 = getelementptr i8, ptr %arg.state, i64 %.982.idx
  %.983 = load double, ptr %.982, align 8
  %.987 = getelementptr i8, ptr %.982, i64 8
  %.988 = load double, ptr %.987, align 8
  %.990 = fmul contract double %.463, %.983
  %.992 = fmul contract double %.473, %.988
  %.993 = fsub contract double %.990, %.992
  %.995 = fmul contract double %.796, %.973
  %.996 = fadd contract double %.995, %.993
  %.998 = fmul contract double %.812, %.979
  %.999 = fadd contract double %.998, %.996
  store double %.999, ptr %.982, align 8
  %.1005 = fmul contract double %.463, %.988
  %.1007 = fmul contract double %.473, %.983
  %.1008 = fadd contract double %.1007, %.1005
  %.1010 = fmul contract double %.804, %.973
  %.1011 = fadd contract double %.1010, %.1008
  %.1013 = fmul contract double %.820, %.979
  %.1014 = fadd contract double %.1013, %.1011
  store double %.1014, ptr %.987, align 8
  %.1033.idx = shl i64 %.975, 4
  %.1033 = getelementptr i8, ptr %arg.found, i64 %.1033.idx
  store double %.999, ptr %.1033, align 8
  %.1040 = getelementptr i8, ptr %.1033, i64 8
  store double %.1014, ptr %.1040, align 8
  %.931 = icmp sgt i64 %.878.0220, 1
  br i1 %.931, label %B886.if, label %B170.loopexit
}

declare i64 @llvm.smin.i64(i64, i64)

declare i64 @llvm.smax.i64(i64, i64)

declare void @llvm.memset.p0.i64(ptr, i8, i64, i1 immarg)

declare void @llvm.memcpy.p0.p0.i64(ptr noalias, ptr noalias, i64, i1 immarg)
