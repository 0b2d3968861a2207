; made from 91466e37b65c52331cf9e63484605f5d45fd36a30853adfa9ba59b2aa1f66781
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

define i64 @march(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, i64 %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, ptr %a14, i64 %a15, ptr %a16, ptr %a17, ptr %a18, ptr %a19, i64 %a20, i64 %a21, ptr %a22, ptr %a23, ptr %a24, ptr %a25, ptr %a26, i64 %a27, i64 %a28, ptr %a29, ptr %a30) {
  %r = alloca i64, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @march.20(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, i64 %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, ptr %a14, i64 %a15, ptr %a16, ptr %a17, ptr %a18, ptr %a19, i64 %a20, i64 %a21, ptr %a22, ptr %a23, ptr %a24, ptr %a25, ptr %a26, i64 %a27, i64 %a28, ptr %a29, ptr %a30)
  %v = load i64, ptr %r, align 8
  ret i64 %v
}

define internal i32 @march.20(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.pos, ptr noalias %arg.numbers, ptr noalias %arg.drive_rows, ptr noalias %arg.drive_columns, i64 %arg.blocks, ptr noalias %arg.own, ptr noalias %arg.slots, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.mass, i64 %arg.tested, ptr noalias %arg.powers, ptr noalias %arg.method, ptr noalias %arg.settings, ptr noalias %arg.edges, i64 %arg.edge_count, i64 %arg.max_steps, ptr noalias %arg.y, ptr noalias %arg.Y, ptr noalias %arg.state, ptr noalias %arg.counts, ptr noalias %arg.outputs, i64 %arg.most_recorded, i64 %arg.record_length, ptr noalias %arg.record, ptr noalias %arg.work) noinline {
entry:
  %.490 = alloca double, align 8
  store double 0.000000e+00, ptr %.490, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.546 = alloca ptr, align 8
  store ptr null, ptr %.546, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.599 = alloca ptr, align 8
  store ptr null, ptr %.599, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.630 = alloca i64, align 8
  store i64 0, ptr %.630, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.692 = alloca ptr, align 8
  store ptr null, ptr %.692, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.732 = alloca ptr, align 8
  store ptr null, ptr %.732, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.759 = alloca ptr, align 8
  store ptr null, ptr %.759, align 8
  %excinfo.7 = alloca ptr, align 8
  store ptr null, ptr %excinfo.7, align 8
  %.793 = alloca double, align 8
  store double 0.000000e+00, ptr %.793, align 8
  %excinfo.8 = alloca ptr, align 8
  store ptr null, ptr %excinfo.8, align 8
  %.828 = alloca double, align 8
  store double 0.000000e+00, ptr %.828, align 8
  %excinfo.9 = alloca ptr, align 8
  store ptr null, ptr %excinfo.9, align 8
  %.877 = alloca double, align 8
  store double 0.000000e+00, ptr %.877, align 8
  %excinfo.10 = alloca ptr, align 8
  store ptr null, ptr %excinfo.10, align 8
  %.1152 = alloca ptr, align 8
  store ptr null, ptr %.1152, align 8
  %excinfo.11 = alloca ptr, align 8
  store ptr null, ptr %excinfo.11, align 8
  %.1198 = alloca double, align 8
  store double 0.000000e+00, ptr %.1198, align 8
  %excinfo.12 = alloca ptr, align 8
  store ptr null, ptr %excinfo.12, align 8
  %.1257 = alloca ptr, align 8
  store ptr null, ptr %.1257, align 8
  %excinfo.13 = alloca ptr, align 8
  store ptr null, ptr %excinfo.13, align 8
  %.1296 = alloca ptr, align 8
  store ptr null, ptr %.1296, align 8
  %excinfo.14 = alloca ptr, align 8
  store ptr null, ptr %excinfo.14, align 8
  %.1341 = alloca ptr, align 8
  store ptr null, ptr %.1341, align 8
  %excinfo.15 = alloca ptr, align 8
  store ptr null, ptr %excinfo.15, align 8
  %.1469 = alloca double, align 8
  store double 0.000000e+00, ptr %.1469, align 8
  %excinfo.16 = alloca ptr, align 8
  store ptr null, ptr %excinfo.16, align 8
  %.1511 = alloca double, align 8
  store double 0.000000e+00, ptr %.1511, align 8
  %excinfo.17 = alloca ptr, align 8
  store ptr null, ptr %excinfo.17, align 8
  %.1566 = alloca double, align 8
  store double 0.000000e+00, ptr %.1566, align 8
  %excinfo.18 = alloca ptr, align 8
  store ptr null, ptr %excinfo.18, align 8
  %.1598 = alloca double, align 8
  store double 0.000000e+00, ptr %.1598, align 8
  %excinfo.19 = alloca ptr, align 8
  store ptr null, ptr %excinfo.19, align 8
  %.95 = load i64, ptr %arg.layout, align 8
  %.97 = getelementptr i8, ptr %arg.layout, i64 16
  %.98 = load i64, ptr %.97, align 8
  %.107 = shl nsw i64 %.95, 3
  %.108 = getelementptr double, ptr %arg.work, i64 %.107
  %.111.idx = mul i64 %.95, 72
  %.111 = getelementptr i8, ptr %arg.work, i64 %.111.idx
  %.idx = mul i64 %.95, 80
  %0 = getelementptr i8, ptr %arg.work, i64 %.idx
  %.115 = getelementptr i8, ptr %0, i64 8
  %.idx173 = mul i64 %.95, 88
  %1 = getelementptr i8, ptr %arg.work, i64 %.idx173
  %.128 = getelementptr i8, ptr %1, i64 8
  %.idx174 = mul i64 %.95, 96
  %2 = getelementptr i8, ptr %arg.work, i64 %.idx174
  %.132 = getelementptr i8, ptr %2, i64 8
  %.142.idx = shl i64 %arg.blocks, 5
  %.142 = getelementptr i8, ptr %.132, i64 %.142.idx
  %.149.idx = shl i64 %arg.blocks, 4
  %.149 = getelementptr i8, ptr %.142, i64 %.149.idx
  %.154 = getelementptr double, ptr %.149, i64 %.98
  %.160 = getelementptr i8, ptr %arg.layout, i64 24
  %.161 = load i64, ptr %.160, align 8
  %3 = getelementptr double, ptr %.154, i64 %.98
  %4 = getelementptr i8, ptr %3, i64 8
  %.164 = getelementptr double, ptr %4, i64 %.161
  %.169 = getelementptr i8, ptr %arg.layout, i64 8
  %.170 = load i64, ptr %.169, align 8
  %5 = getelementptr double, ptr %.164, i64 %.170
  %.173 = getelementptr i8, ptr %5, i64 8
  %.178 = getelementptr i8, ptr %arg.layout, i64 48
  %.179 = load i64, ptr %.178, align 8
  %.181 = getelementptr double, ptr %.173, i64 %.179
  %6 = getelementptr double, ptr %arg.edges, i64 %arg.edge_count
  %.188 = getelementptr i8, ptr %6, i64 -8
  %.189 = load double, ptr %.188, align 8
  %.195 = load i64, ptr %arg.counts, align 8
  %.287287.not = icmp slt i64 %arg.max_steps, 1
  br i1 %.287287.not, label %B2860, label %B672.if.lr.ph

B672.if.lr.ph:
  %.429 = getelementptr i8, ptr %arg.state, i64 8
  %.571 = getelementptr i8, ptr %arg.counts, i64 32
  %.581 = getelementptr i8, ptr %arg.method, i64 1344
  %.592 = getelementptr i32, ptr %arg.lu_start, i64 %arg.blocks
  %.655 = getelementptr i8, ptr %arg.counts, i64 8
  %.717 = getelementptr i8, ptr %arg.counts, i64 24
  %.727.idx = mul i64 %.95, 56
  %.727 = getelementptr i8, ptr %arg.work, i64 %.727.idx
  %.784 = getelementptr i8, ptr %arg.settings, i64 8
  %.1191 = getelementptr i8, ptr %arg.state, i64 16
  %.1194 = getelementptr i8, ptr %arg.method, i64 1352
  %.1226 = icmp sgt i64 %arg.most_recorded, 0
  %.1282 = add nsw i64 %.95, 3
  %.1284 = icmp sgt i64 %arg.record_length, %.1282
  %.1330 = getelementptr i8, ptr %arg.counts, i64 40
  %.1562 = getelementptr i8, ptr %arg.settings, i64 16
  %.865 = getelementptr i8, ptr %arg.counts, i64 16
  %.873 = getelementptr i8, ptr %arg.method, i64 1352
  %.914 = getelementptr i8, ptr %arg.settings, i64 24
  %7 = add i64 %arg.edge_count, -1
  br label %B672.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B688 ], [ 0, %B1748 ], [ 0, %B2860 ], [ %.1604, %B2728.endif.if ], [ %.1572, %B2728.if ], [ %.496, %B818.endif.if ], [ %.550, %B860.if ], [ %.603, %B966.endif.if ], [ %.634, %B966.endif.endif.if ], [ %.696, %B1176.if ], [ %.736, %B1176.endif.if ], [ %.763, %B1176.endif.endif.if ], [ %.799, %B1176.endif.endif.endif.endif.if ], [ %.832, %B1176.endif.endif.endif.endif.endif.if ], [ %.881, %B1570.if ], [ %.1156, %B1942.if ], [ %.1202, %B2156.if ], [ %.1261, %B2248.if ], [ %.1300, %B2418.if ], [ %.1345, %B2542.if ], [ 0, %B2600.endif.endif.endif ], [ %.1475, %B2600.if ], [ %.1517, %B2600.endif.endif.if ]
  ret i32 %common.ret.op

B688:
  store i64 1, ptr %retptr, align 8
  br label %common.ret

B706:
  %.427 = load double, ptr %arg.state, align 8
  %.430 = load double, ptr %.429, align 8
  %.439 = fsub contract double %.189, %.427
  %.444 = fmul contract double %.439, 0x3FEFFFFFFF768FA1
  %.446 = fcmp contract oge double %.430, %.444
  br i1 %.446, label %B856, label %B800

B800:
  %.475 = fmul contract double %.439, 5.000000e-01
  %.477 = fcmp contract ogt double %.430, %.475
  br i1 %.477, label %B818, label %B856

B818:
  store double 0.000000e+00, ptr %.490, align 8
  %.496 = call i32 @numba.21(ptr nonnull %.490, ptr nonnull %excinfo.1, double %.430, double %.475)
  switch i32 %.496, label %B818.endif.if [
    i32 -2, label %B818.endif.endif
    i32 0, label %B818.endif.endif
  ]

B856:
  %h.3.1 = phi double [ %.430, %B800 ], [ %.506, %B818.endif.endif ], [ %.439, %B706 ]
  br i1 %fresh.3.0290, label %B966, label %B860

B860:
  store ptr null, ptr %.546, align 8
  %.550 = call i32 @linearise.22(ptr nonnull %.546, ptr nonnull %excinfo.2, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.pos, ptr %arg.numbers, ptr %arg.drive_rows, ptr %arg.drive_columns, double %.427, ptr %arg.y, ptr %arg.Y, ptr %.154, ptr %.164, ptr %.128, ptr %.173, ptr %.181)
  switch i32 %.550, label %B860.if [
    i32 -2, label %B860.endif
    i32 0, label %B860.endif
  ]

B966:
  %.582 = load double, ptr %.581, align 8
  %.584 = fmul contract double %h.3.1, %.582
  %.588 = fdiv contract double 1.000000e+00, %.584
  %.593 = load i32, ptr %.592, align 4
  store ptr null, ptr %.599, align 8
  %.603 = call i32 @lu_fill.23(ptr nonnull %.599, ptr nonnull %excinfo.3, i64 %.95, i32 %.593, ptr %.154, ptr %arg.own, ptr %arg.mass, double %.588, ptr %.149)
  switch i32 %.603, label %B966.endif.if [
    i32 -2, label %B966.endif.endif
    i32 0, label %B966.endif.endif
  ]

B1176:
  store ptr null, ptr %.692, align 8
  %.696 = call i32 @solve_stages.24(ptr nonnull %.692, ptr nonnull %excinfo.5, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, i64 %arg.blocks, ptr %arg.slots, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %arg.mass, ptr %arg.method, double %.427, double %h.3.1, ptr %arg.y, ptr %arg.Y, ptr %.128, ptr %.149, ptr %arg.work, ptr %.108, i64 0, ptr %.111, ptr %.115, ptr %.142, ptr %.173, ptr %.181)
  switch i32 %.696, label %B1176.if [
    i32 -2, label %B1176.endif
    i32 0, label %B1176.endif
  ]

B1558:
  %error.2.1 = phi double [ %.842, %B1176.endif.endif.endif.endif.endif.endif ], [ 0x7FF0000000000000, %B966.endif.endif.endif ]
  %.856 = fcmp contract ugt double %error.2.1, 1.000000e+00
  br i1 %.856, label %B1570, label %B1770

B1570:
  %.866 = load i64, ptr %.865, align 8
  %.867 = add nsw i64 %.866, 1
  store i64 %.867, ptr %.865, align 8
  %.874 = load double, ptr %.873, align 8
  store double 0.000000e+00, ptr %.877, align 8
  %.881 = call i32 @step_factor.25(ptr nonnull %.877, ptr nonnull %excinfo.10, double %error.2.1, double 1.000000e+00, double %.874, ptr %arg.settings)
  switch i32 %.881, label %B1570.if [
    i32 -2, label %B1570.endif
    i32 0, label %B1570.endif
  ]

B1748:
  store i64 2, ptr %retptr, align 8
  br label %common.ret

B1770:
  %.1031 = fadd contract double %.427, %h.3.1
  %until.2.1 = select i1 %.446, double %.189, double %.1031
  %.1043 = load i64, ptr %arg.counts, align 8
  %.1053 = icmp slt i64 %.1043, %arg.edge_count
  br i1 %.1053, label %B1826, label %B1908

B1826:
  %.1064 = getelementptr double, ptr %arg.edges, i64 %.1043
  %.1065 = load double, ptr %.1064, align 8
  %.1069 = fmul contract double %until.2.1, 0x3FF0000000000005
  %.1070 = fcmp contract ugt double %.1065, %.1069
  br i1 %.1070, label %B1908, label %B1856

B1856:
  %stop.2.1 = phi i64 [ %.1076, %B1878 ], [ %.1043, %B1826 ]
  %exitcond.not = icmp eq i64 %stop.2.1, %7
  br i1 %exitcond.not, label %B1908, label %B1878

B1878:
  %.1076 = add nsw i64 %stop.2.1, 1
  %.1097 = getelementptr double, ptr %arg.edges, i64 %.1076
  %.1098 = load double, ptr %.1097, align 8
  %.1103 = fcmp contract ugt double %.1098, %.1069
  br i1 %.1103, label %B1908, label %B1856

B1908:
  %stop.3.2 = phi i64 [ %.1043, %B1826 ], [ %.1043, %B1770 ], [ %arg.edge_count, %B1856 ], [ %.1076, %B1878 ]
  %.1120 = icmp sgt i64 %stop.3.2, %.1043
  br i1 %.1120, label %B1942, label %B2156

B1942:
  %.1127 = getelementptr double, ptr %arg.edges, i64 %.1043
  %.1132 = sub nsw i64 %stop.3.2, %.1043
  %.1137 = sub nsw i64 %.1043, %.195
  %.1139 = mul nsw i64 %.1137, %.95
  %.1141 = getelementptr double, ptr %arg.outputs, i64 %.1139
  store ptr null, ptr %.1152, align 8
  %.1156 = call i32 @dense_output.26(ptr nonnull %.1152, ptr nonnull %excinfo.11, i64 %.95, ptr %arg.y, ptr %.115, ptr %arg.work, ptr %arg.method, double %.427, double %until.2.1, ptr %.1127, i64 %.1132, ptr %.1141, ptr %.111, ptr %.132, ptr %.142)
  switch i32 %.1156, label %B1942.if [
    i32 -2, label %B1942.endif
    i32 0, label %B1942.endif
  ]

B2156:
  %.1192 = load double, ptr %.1191, align 8
  %.1195 = load double, ptr %.1194, align 8
  store double 0.000000e+00, ptr %.1198, align 8
  %.1202 = call i32 @step_factor.25(ptr nonnull %.1198, ptr nonnull %excinfo.12, double %error.2.1, double %.1192, double %.1195, ptr %arg.settings)
  %.1212 = load double, ptr %.1198, align 8
  switch i32 %.1202, label %B2156.if [
    i32 -2, label %B2156.endif
    i32 0, label %B2156.endif
  ]

B2248:
  %.1232 = mul nsw i64 %recorded.2.0289, %arg.record_length
  %.1234 = getelementptr double, ptr %arg.record, i64 %.1232
  store double %.427, ptr %.1234, align 8
  %.1246 = getelementptr i8, ptr %.1234, i64 8
  store double %h.3.1, ptr %.1246, align 8
  %.1250 = getelementptr i8, ptr %.1234, i64 16
  store double %until.2.1, ptr %.1250, align 8
  %.1254 = getelementptr i8, ptr %.1234, i64 24
  store ptr null, ptr %.1257, align 8
  %.1261 = call i32 @copy.27(ptr nonnull %.1257, ptr nonnull %excinfo.13, i64 %.95, ptr %arg.y, ptr %.1254)
  switch i32 %.1261, label %B2248.if [
    i32 -2, label %B2248.endif
    i32 0, label %B2248.endif
  ]

B2418:
  %.1292 = getelementptr double, ptr %.1234, i64 %.1282
  store ptr null, ptr %.1296, align 8
  %.1300 = call i32 @copy.27(ptr nonnull %.1296, ptr nonnull %excinfo.14, i64 %.107, ptr %arg.work, ptr %.1292)
  switch i32 %.1300, label %B2418.if [
    i32 -2, label %B2512
    i32 0, label %B2512
  ]

B2512:
  %.1324 = add nsw i64 %recorded.2.0289, 1
  store i64 %.1324, ptr %.1330, align 8
  br label %B2542

B2542:
  %recorded.4.1 = phi i64 [ %.1324, %B2512 ], [ %recorded.2.0289, %B2156.endif ]
  store ptr null, ptr %.1341, align 8
  %.1345 = call i32 @copy.27(ptr nonnull %.1341, ptr nonnull %excinfo.15, i64 %.95, ptr %.115, ptr %arg.y)
  switch i32 %.1345, label %B2542.if [
    i32 -2, label %B2542.endif
    i32 0, label %B2542.endif
  ]

B2600:
  store double 0.000000e+00, ptr %.1469, align 8
  %.1475 = call i32 @numba.28(ptr nonnull %.1469, ptr nonnull %excinfo.16, double %.430, double %h.3.1)
  %.1485 = load double, ptr %.1469, align 8
  switch i32 %.1475, label %B2600.if [
    i32 -2, label %B2600.endif
    i32 0, label %B2600.endif
  ]

B2728:
  %.1556 = fmul contract double %h.3.1, %.1212
  %.1563 = load double, ptr %.1562, align 8
  store double 0.000000e+00, ptr %.1566, align 8
  %.1572 = call i32 @numba.21(ptr nonnull %.1566, ptr nonnull %excinfo.18, double %.1556, double %.1563)
  switch i32 %.1572, label %B2728.if [
    i32 -2, label %B2728.endif
    i32 0, label %B2728.endif
  ]

B2860:
  store i64 1, ptr %retptr, align 8
  br label %common.ret

B2861:
  %recorded.3.1 = phi i64 [ %recorded.4.1, %B2728.endif.endif ], [ %recorded.2.0289, %B1570.endif ]
  %.287 = icmp sgt i64 %.231.0288, 1
  br i1 %.287, label %B672.if, label %B2860

B672.if:
  %fresh.3.0290 = phi i1 [ false, %B672.if.lr.ph ], [ %.856, %B2861 ]
  %recorded.2.0289 = phi i64 [ 0, %B672.if.lr.ph ], [ %recorded.3.1, %B2861 ]
  %.231.0288 = phi i64 [ %arg.max_steps, %B672.if.lr.ph ], [ %.296, %B2861 ]
  %.296 = add nsw i64 %.231.0288, -1
  %.327 = icmp eq i64 %recorded.2.0289, %arg.most_recorded
  br i1 %.327, label %B688, label %B706

B818.endif.if:
  %.504 = icmp sgt i32 %.496, 0
  %.497 = load ptr, ptr %excinfo.1, align 8
  %.505 = select i1 %.504, ptr %.497, ptr undef
  store ptr %.505, ptr %excinfo, align 8
  br label %common.ret

B818.endif.endif:
  %.506 = load double, ptr %.490, align 8
  br label %B856

B860.if:
  %.558 = icmp sgt i32 %.550, 0
  %.551 = load ptr, ptr %excinfo.2, align 8
  %.559 = select i1 %.558, ptr %.551, ptr undef
  store ptr %.559, ptr %excinfo, align 8
  br label %common.ret

B860.endif:
  %.572 = load i64, ptr %.571, align 8
  %.573 = add nsw i64 %.572, 1
  store i64 %.573, ptr %.571, align 8
  br label %B966

B966.endif.if:
  %.611 = icmp sgt i32 %.603, 0
  %.604 = load ptr, ptr %excinfo.3, align 8
  %.612 = select i1 %.611, ptr %.604, ptr undef
  store ptr %.612, ptr %excinfo, align 8
  br label %common.ret

B966.endif.endif:
  store i64 0, ptr %.630, align 8
  %.634 = call i32 @lu_factor.17(ptr nonnull %.630, ptr nonnull %excinfo.4, i64 %arg.blocks, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %.149, ptr %.132)
  switch i32 %.634, label %B966.endif.endif.if [
    i32 -2, label %B966.endif.endif.endif
    i32 0, label %B966.endif.endif.endif
  ]

B966.endif.endif.if:
  %.642 = icmp sgt i32 %.634, 0
  %.635 = load ptr, ptr %excinfo.4, align 8
  %.643 = select i1 %.642, ptr %.635, ptr undef
  store ptr %.643, ptr %excinfo, align 8
  br label %common.ret

B966.endif.endif.endif:
  %.644 = load i64, ptr %.630, align 8
  %.656 = load i64, ptr %.655, align 8
  %.657 = add nsw i64 %.656, 1
  store i64 %.657, ptr %.655, align 8
  %.664 = icmp eq i64 %.644, 0
  br i1 %.664, label %B1176, label %B1558

B1176.if:
  %.704 = icmp sgt i32 %.696, 0
  %.697 = load ptr, ptr %excinfo.5, align 8
  %.705 = select i1 %.704, ptr %.697, ptr undef
  store ptr %.705, ptr %excinfo, align 8
  br label %common.ret

B1176.endif:
  %.718 = load i64, ptr %.717, align 8
  %.719 = add nsw i64 %.718, 8
  store i64 %.719, ptr %.717, align 8
  store ptr null, ptr %.732, align 8
  %.736 = call i32 @copy.27(ptr nonnull %.732, ptr nonnull %excinfo.6, i64 %.95, ptr %.108, ptr %.115)
  switch i32 %.736, label %B1176.endif.if [
    i32 -2, label %B1176.endif.endif
    i32 0, label %B1176.endif.endif
  ]

B1176.endif.if:
  %.744 = icmp sgt i32 %.736, 0
  %.737 = load ptr, ptr %excinfo.6, align 8
  %.745 = select i1 %.744, ptr %.737, ptr undef
  store ptr %.745, ptr %excinfo, align 8
  br label %common.ret

B1176.endif.endif:
  store ptr null, ptr %.759, align 8
  %.763 = call i32 @add_scaled.29(ptr nonnull %.759, ptr nonnull %excinfo.7, i64 %.95, double 1.000000e+00, ptr %.727, ptr %.115)
  switch i32 %.763, label %B1176.endif.endif.if [
    i32 -2, label %B1176.endif.endif.endif
    i32 0, label %B1176.endif.endif.endif
  ]

B1176.endif.endif.if:
  %.771 = icmp sgt i32 %.763, 0
  %.764 = load ptr, ptr %excinfo.7, align 8
  %.772 = select i1 %.771, ptr %.764, ptr undef
  store ptr %.772, ptr %excinfo, align 8
  br label %common.ret

B1176.endif.endif.endif:
  %.785 = load double, ptr %.784, align 8
  %.790 = fdiv contract double %h.3.1, %.785
  store double 0.000000e+00, ptr %.793, align 8
  %.799 = call i32 @numba.21(ptr nonnull %.793, ptr nonnull %excinfo.8, double 1.000000e+00, double %.790)
  switch i32 %.799, label %B1176.endif.endif.endif.endif.if [
    i32 -2, label %B1176.endif.endif.endif.endif.endif
    i32 0, label %B1176.endif.endif.endif.endif.endif
  ]

B1176.endif.endif.endif.endif.if:
  %.807 = icmp sgt i32 %.799, 0
  %.800 = load ptr, ptr %excinfo.8, align 8
  %.808 = select i1 %.807, ptr %.800, ptr undef
  store ptr %.808, ptr %excinfo, align 8
  br label %common.ret

B1176.endif.endif.endif.endif.endif:
  %.809 = load double, ptr %.793, align 8
  %.822 = load double, ptr %arg.settings, align 8
  store double 0.000000e+00, ptr %.828, align 8
  %.832 = call i32 @step_error.30(ptr nonnull %.828, ptr nonnull %excinfo.9, i64 %.95, i64 %arg.tested, ptr %arg.y, ptr %.115, ptr %.727, ptr %arg.powers, double %.809, double %.822)
  switch i32 %.832, label %B1176.endif.endif.endif.endif.endif.if [
    i32 -2, label %B1176.endif.endif.endif.endif.endif.endif
    i32 0, label %B1176.endif.endif.endif.endif.endif.endif
  ]

B1176.endif.endif.endif.endif.endif.if:
  %.840 = icmp sgt i32 %.832, 0
  %.833 = load ptr, ptr %excinfo.9, align 8
  %.841 = select i1 %.840, ptr %.833, ptr undef
  store ptr %.841, ptr %excinfo, align 8
  br label %common.ret

B1176.endif.endif.endif.endif.endif.endif:
  %.842 = load double, ptr %.828, align 8
  br label %B1558

B1570.if:
  %.889 = icmp sgt i32 %.881, 0
  %.882 = load ptr, ptr %excinfo.10, align 8
  %.890 = select i1 %.889, ptr %.882, ptr undef
  store ptr %.890, ptr %excinfo, align 8
  br label %common.ret

B1570.endif:
  %.891 = load double, ptr %.877, align 8
  %.904 = fmul contract double %h.3.1, %.891
  store double %.904, ptr %.429, align 8
  %.915 = load double, ptr %.914, align 8
  %.916 = fcmp contract olt double %.904, %.915
  br i1 %.916, label %B1748, label %B2861

B1942.if:
  %.1164 = icmp sgt i32 %.1156, 0
  %.1157 = load ptr, ptr %excinfo.11, align 8
  %.1165 = select i1 %.1164, ptr %.1157, ptr undef
  store ptr %.1165, ptr %excinfo, align 8
  br label %common.ret

B1942.endif:
  store i64 %stop.3.2, ptr %arg.counts, align 8
  br label %B2156

B2156.if:
  %.1210 = icmp sgt i32 %.1202, 0
  %.1203 = load ptr, ptr %excinfo.12, align 8
  %.1211 = select i1 %.1210, ptr %.1203, ptr undef
  store ptr %.1211, ptr %excinfo, align 8
  br label %common.ret

B2156.endif:
  br i1 %.1226, label %B2248, label %B2542

B2248.if:
  %.1269 = icmp sgt i32 %.1261, 0
  %.1262 = load ptr, ptr %excinfo.13, align 8
  %.1270 = select i1 %.1269, ptr %.1262, ptr undef
  store ptr %.1270, ptr %excinfo, align 8
  br label %common.ret

B2248.endif:
  br i1 %.1284, label %B2418, label %B2512

B2418.if:
  %.1308 = icmp sgt i32 %.1300, 0
  %.1301 = load ptr, ptr %excinfo.14, align 8
  %.1309 = select i1 %.1308, ptr %.1301, ptr undef
  store ptr %.1309, ptr %excinfo, align 8
  br label %common.ret

B2542.if:
  %.1353 = icmp sgt i32 %.1345, 0
  %.1346 = load ptr, ptr %excinfo.15, align 8
  %.1354 = select i1 %.1353, ptr %.1346, ptr undef
  store ptr %.1354, ptr %excinfo, align 8
  br label %common.ret

B2542.endif:
  store double %until.2.1, ptr %arg.state, align 8
  br i1 %.446, label %B2600, label %B2728

B2600.if:
  %.1483 = icmp sgt i32 %.1475, 0
  %.1476 = load ptr, ptr %excinfo.16, align 8
  %.1484 = select i1 %.1483, ptr %.1476, ptr undef
  store ptr %.1484, ptr %excinfo, align 8
  br label %common.ret

B2600.endif:
  %.1500 = getelementptr i8, ptr %arg.settings, i64 32
  %.1501 = load double, ptr %.1500, align 8
  %.1507 = fdiv contract double 1.000000e+00, %.1501
  store double 0.000000e+00, ptr %.1511, align 8
  %.1517 = call i32 @numba.21(ptr nonnull %.1511, ptr nonnull %excinfo.17, double %.1212, double %.1507)
  switch i32 %.1517, label %B2600.endif.endif.if [
    i32 -2, label %B2600.endif.endif.endif
    i32 0, label %B2600.endif.endif.endif
  ]

B2600.endif.endif.if:
  %.1525 = icmp sgt i32 %.1517, 0
  %.1518 = load ptr, ptr %excinfo.17, align 8
  %.1526 = select i1 %.1525, ptr %.1518, ptr undef
  store ptr %.1526, ptr %excinfo, align 8
  br label %common.ret

B2600.endif.endif.endif:
  %.1527 = load double, ptr %.1511, align 8
  %.1539 = fmul contract double %.1485, %.1527
  store double %.1539, ptr %.429, align 8
  store i64 0, ptr %retptr, align 8
  br label %common.ret

B2728.if:
  %.1580 = icmp sgt i32 %.1572, 0
  %.1573 = load ptr, ptr %excinfo.18, align 8
  %.1581 = select i1 %.1580, ptr %.1573, ptr undef
  store ptr %.1581, ptr %excinfo, align 8
  br label %common.ret

B2728.endif:
  %.1582 = load double, ptr %.1566, align 8
  store double %.1582, ptr %.429, align 8
  store double 0.000000e+00, ptr %.1598, align 8
  %.1604 = call i32 @numba.28(ptr nonnull %.1598, ptr nonnull %excinfo.19, double %error.2.1, double 1.000000e-04)
  switch i32 %.1604, label %B2728.endif.if [
    i32 -2, label %B2728.endif.endif
    i32 0, label %B2728.endif.endif
  ]

B2728.endif.if:
  %.1612 = icmp sgt i32 %.1604, 0
  %.1605 = load ptr, ptr %excinfo.19, align 8
  %.1613 = select i1 %.1612, ptr %.1605, ptr undef
  store ptr %.1613, ptr %excinfo, align 8
  br label %common.ret

B2728.endif.endif:
  %.1614 = load double, ptr %.1598, align 8
  store double %.1614, ptr %.1191, align 8
  br label %B2861
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
  %.219 = alloca ptr, align 8
  store ptr null, ptr %.219, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.251 = alloca ptr, align 8
  store ptr null, ptr %.251, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.301 = alloca ptr, align 8
  store ptr null, ptr %.301, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.335 = alloca ptr, align 8
  store ptr null, ptr %.335, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.372 = alloca ptr, align 8
  store ptr null, ptr %.372, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.414 = alloca ptr, align 8
  store ptr null, ptr %.414, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.460 = alloca ptr, align 8
  store ptr null, ptr %.460, align 8
  %excinfo.7 = alloca ptr, align 8
  store ptr null, ptr %excinfo.7, align 8
  %.84 = load i64, ptr %arg.layout, align 8
  %.285 = getelementptr i8, ptr %arg.layout, i64 8
  %0 = getelementptr double, ptr %arg.Y, i64 %.84
  br label %B72.if

B498:
  store ptr null, ptr %.414, align 8
  %.418 = call i32 @add_scaled.29(ptr nonnull %.414, ptr nonnull %excinfo.6, i64 %.84, double %.402, ptr %arg.drift, ptr %arg.right)
  switch i32 %.418, label %B498.if [
    i32 -2, label %B534
    i32 0, label %B534
  ]

B534:
  %.445 = mul nsw i64 %.111.080, %.84
  %.449 = getelementptr double, ptr %arg.stages, i64 %.445
  store ptr null, ptr %.460, align 8
  %.464 = call i32 @lu_solve.19(ptr nonnull %.460, ptr nonnull %excinfo.7, i64 %.84, ptr %arg.slots, i64 %arg.blocks, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %arg.lu, ptr %arg.right, ptr %.449, ptr %arg.x)
  switch i32 %.464, label %B534.if [
    i32 -2, label %B534.endif
    i32 0, label %B534.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ 0, %B624 ], [ %.464, %B534.if ], [ %.418, %B498.if ], [ %.223, %B74.if ], [ %.255, %B74.endif.if ], [ %.305, %B74.endif.endif.if ], [ %.339, %B74.endif.endif.endif.if ], [ %.376, %B74.endif.endif.endif.endif.if ]
  ret i32 %common.ret.op

B624:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B72.if:
  %.111.080 = phi i64 [ 0, %entry ], [ %.183, %B534.endif ]
  %.183 = add nuw nsw i64 %.111.080, 1
  store ptr null, ptr %.219, align 8
  %.223 = call i32 @set_place.31(ptr nonnull %.219, ptr nonnull %excinfo.1, i64 %.84, i64 %.111.080, ptr %arg.method, ptr %arg.y, ptr %arg.stages, ptr %arg.place_, i64 %arg.stride)
  switch i32 %.223, label %B74.if [
    i32 -2, label %B74.endif
    i32 0, label %B74.endif
  ]

B74.if:
  %.231 = icmp sgt i32 %.223, 0
  %.224 = load ptr, ptr %excinfo.1, align 8
  %.232 = select i1 %.231, ptr %.224, ptr undef
  store ptr %.232, ptr %excinfo, align 8
  br label %common.ret

B74.endif:
  store ptr null, ptr %.251, align 8
  %.255 = call i32 @copy.27(ptr nonnull %.251, ptr nonnull %excinfo.2, i64 %.84, ptr %arg.place_, ptr %arg.Y)
  switch i32 %.255, label %B74.endif.if [
    i32 -2, label %B74.endif.endif
    i32 0, label %B74.endif.endif
  ]

B74.endif.if:
  %.263 = icmp sgt i32 %.255, 0
  %.256 = load ptr, ptr %excinfo.2, align 8
  %.264 = select i1 %.263, ptr %.256, ptr undef
  store ptr %.264, ptr %excinfo, align 8
  br label %common.ret

B74.endif.endif:
  %1 = getelementptr double, ptr %arg.method, i64 %.111.080
  %.278 = getelementptr i8, ptr %1, i64 1024
  %.279 = load double, ptr %.278, align 8
  %.281 = fmul contract double %arg.h, %.279
  %.283 = fadd contract double %arg.time, %.281
  %.286 = load i64, ptr %.285, align 8
  %.290 = getelementptr double, ptr %0, i64 %.286
  store double %.283, ptr %.290, align 8
  store ptr null, ptr %.301, align 8
  %.305 = call i32 @drive.6(ptr nonnull %.301, ptr nonnull %excinfo.3, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.local, ptr %arg.out)
  switch i32 %.305, label %B74.endif.endif.if [
    i32 -2, label %B74.endif.endif.endif
    i32 0, label %B74.endif.endif.endif
  ]

B74.endif.endif.if:
  %.313 = icmp sgt i32 %.305, 0
  %.306 = load ptr, ptr %excinfo.3, align 8
  %.314 = select i1 %.313, ptr %.306, ptr undef
  store ptr %.314, ptr %excinfo, align 8
  br label %common.ret

B74.endif.endif.endif:
  store ptr null, ptr %.335, align 8
  %.339 = call i32 @residual.0(ptr nonnull %.335, ptr nonnull %excinfo.4, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.right, ptr %arg.local, ptr %arg.out)
  switch i32 %.339, label %B74.endif.endif.endif.if [
    i32 -2, label %B74.endif.endif.endif.endif
    i32 0, label %B74.endif.endif.endif.endif
  ]

B74.endif.endif.endif.if:
  %.347 = icmp sgt i32 %.339, 0
  %.340 = load ptr, ptr %excinfo.4, align 8
  %.348 = select i1 %.347, ptr %.340, ptr undef
  store ptr %.348, ptr %excinfo, align 8
  br label %common.ret

B74.endif.endif.endif.endif:
  %.idx = shl i64 %.111.080, 6
  %2 = getelementptr i8, ptr %arg.method, i64 %.idx
  %.364 = getelementptr i8, ptr %2, i64 512
  store ptr null, ptr %.372, align 8
  %.376 = call i32 @combine.32(ptr nonnull %.372, ptr nonnull %excinfo.5, i64 %.84, i64 %.111.080, ptr %.364, double %arg.h, ptr %arg.mass, ptr %arg.stages, ptr %arg.right, ptr %arg.after)
  switch i32 %.376, label %B74.endif.endif.endif.endif.if [
    i32 -2, label %B74.endif.endif.endif.endif.endif
    i32 0, label %B74.endif.endif.endif.endif.endif
  ]

B74.endif.endif.endif.endif.if:
  %.384 = icmp sgt i32 %.376, 0
  %.377 = load ptr, ptr %excinfo.5, align 8
  %.385 = select i1 %.384, ptr %.377, ptr undef
  store ptr %.385, ptr %excinfo, align 8
  br label %common.ret

B74.endif.endif.endif.endif.endif:
  %.399 = getelementptr i8, ptr %1, i64 1088
  %.400 = load double, ptr %.399, align 8
  %.402 = fmul contract double %arg.h, %.400
  %.407 = fcmp contract une double %.402, 0.000000e+00
  br i1 %.407, label %B498, label %B534

B498.if:
  %.426 = icmp sgt i32 %.418, 0
  %.419 = load ptr, ptr %excinfo.6, align 8
  %.427 = select i1 %.426, ptr %.419, ptr undef
  store ptr %.427, ptr %excinfo, align 8
  br label %common.ret

B534.if:
  %.472 = icmp sgt i32 %.464, 0
  %.465 = load ptr, ptr %excinfo.7, align 8
  %.473 = select i1 %.472, ptr %.465, ptr undef
  store ptr %.473, ptr %excinfo, align 8
  br label %common.ret

B534.endif:
  %exitcond.not = icmp eq i64 %.183, 8
  br i1 %exitcond.not, label %B624, label %B72.if
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

define internal i32 @set_place.31(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, i64 %arg.i, ptr noalias %arg.method, ptr noalias %arg.y, ptr noalias %arg.stages, ptr noalias %arg.place_, i64 %arg.stride) noinline {
entry:
  %.44 = alloca ptr, align 8
  store ptr null, ptr %.44, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.203 = alloca ptr, align 8
  store ptr null, ptr %.203, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.305 = alloca ptr, align 8
  store ptr null, ptr %.305, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.34 = icmp slt i64 %arg.i, 6
  br i1 %.34, label %B64, label %B232

B64:
  store ptr null, ptr %.44, align 8
  %.48 = call i32 @copy.27(ptr nonnull %.44, ptr nonnull %excinfo.1, i64 %arg.n, ptr %arg.y, ptr %arg.place_)
  switch i32 %.48, label %B64.if [
    i32 -2, label %B64.endif
    i32 0, label %B64.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ 0, %B228 ], [ %.207, %B130.if ], [ %.309, %B318.if ], [ %.48, %B64.if ], [ 0, %B318.endif ]
  ret i32 %common.ret.op

B228:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B232:
  %.294 = add nsw i64 %arg.i, -1
  %.298 = mul nsw i64 %.294, %arg.n
  %.300 = getelementptr double, ptr %arg.stages, i64 %.298
  store ptr null, ptr %.305, align 8
  %.309 = call i32 @add_scaled.29(ptr nonnull %.305, ptr nonnull %excinfo.4, i64 %arg.n, double 1.000000e+00, ptr %.300, ptr %arg.place_)
  switch i32 %.309, label %B318.if [
    i32 -2, label %B318.endif
    i32 0, label %B318.endif
  ]

B64.if:
  %.56 = icmp sgt i32 %.48, 0
  %.49 = load ptr, ptr %excinfo.1, align 8
  %.57 = select i1 %.56, ptr %.49, ptr undef
  store ptr %.57, ptr %excinfo, align 8
  br label %common.ret

B64.endif:
  %.15252.not = icmp slt i64 %arg.i, 1
  br i1 %.15252.not, label %B228, label %B128.if.lr.ph

B128.if.lr.ph:
  %.idx = shl nuw nsw i64 %arg.i, 6
  %0 = getelementptr i8, ptr %arg.method, i64 %.idx
  br label %B128.if

B128.if:
  %.96.053 = phi i64 [ 0, %B128.if.lr.ph ], [ %.165, %B130.endif ]
  %.195 = getelementptr double, ptr %0, i64 %.96.053
  %.196 = load double, ptr %.195, align 8
  %.198 = mul nsw i64 %.96.053, %arg.n
  %.200 = getelementptr double, ptr %arg.stages, i64 %.198
  store ptr null, ptr %.203, align 8
  %.207 = call i32 @add_scaled.29(ptr nonnull %.203, ptr nonnull %excinfo.2, i64 %arg.n, double %.196, ptr %.200, ptr %arg.place_)
  switch i32 %.207, label %B130.if [
    i32 -2, label %B130.endif
    i32 0, label %B130.endif
  ]

B130.if:
  %.215 = icmp sgt i32 %.207, 0
  %.208 = load ptr, ptr %excinfo.2, align 8
  %.216 = select i1 %.215, ptr %.208, ptr undef
  store ptr %.216, ptr %excinfo, align 8
  br label %common.ret

B130.endif:
  %.165 = add nuw nsw i64 %.96.053, 1
  %exitcond.not = icmp eq i64 %.165, %arg.i
  br i1 %exitcond.not, label %B228, label %B128.if

B318.if:
  %.317 = icmp sgt i32 %.309, 0
  %.310 = load ptr, ptr %excinfo.4, align 8
  %.318 = select i1 %.317, ptr %.310, ptr undef
  store ptr %.318, ptr %excinfo, align 8
  br label %common.ret

B318.endif:
  store ptr null, ptr %retptr, align 8
  br label %common.ret
}

define internal i32 @combine.32(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, i64 %arg.count, ptr noalias %arg.weights, double %arg.h, ptr noalias %arg.mass, ptr noalias %arg.stages, ptr noalias %arg.right, ptr noalias %arg.pull) noinline {
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
  %1 = call i32 @sums_of_rows.33(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, i64 %a5, i64 %a6, ptr %a7, i64 %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13)
  ret i64 0
}

define internal i32 @sums_of_rows.33(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.pos, i64 %arg.count, i64 %arg.own, ptr noalias %arg.numbers, i64 %arg.length, ptr noalias %arg.Y, ptr noalias %arg.J, ptr noalias %arg.r, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
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
  %1 = call i32 @march_rows.34(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, i64 %a7, ptr %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, i64 %a14, ptr %a15, ptr %a16, i64 %a17, i64 %a18, ptr %a19, i64 %a20, ptr %a21, ptr %a22, ptr %a23, ptr %a24, ptr %a25, i64 %a26, ptr %a27, ptr %a28, ptr %a29, ptr %a30, ptr %a31)
  ret i64 0
}

define internal i32 @march_rows.34(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.pos, ptr noalias %arg.drive_rows, ptr noalias %arg.drive_columns, i64 %arg.blocks, ptr noalias %arg.slot, ptr noalias %arg.slots, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.mass, i64 %arg.tested, ptr noalias %arg.powers, ptr noalias %arg.method, i64 %arg.count, i64 %arg.own, ptr noalias %arg.numbers, i64 %arg.length, ptr noalias %arg.Y, ptr noalias %arg.y, ptr noalias %arg.settings, ptr noalias %arg.first_edges, ptr noalias %arg.edges, i64 %arg.max_steps, ptr noalias %arg.state, ptr noalias %arg.counts, ptr noalias %arg.outputs, ptr noalias %arg.status, ptr noalias %arg.work) noinline {
entry:
  %.343 = alloca i64, align 8
  store i64 0, ptr %.343, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.100 = load i64, ptr %arg.layout, align 8
  %.18643.not = icmp slt i64 %arg.count, 1
  br i1 %.18643.not, label %B584, label %B62.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B584 ], [ %.347, %B64.if ]
  ret i32 %common.ret.op

B584:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B62.if:
  %.127.044 = phi i64 [ %.199, %B64.endif ], [ 0, %entry ]
  %.225 = getelementptr i64, ptr %arg.first_edges, i64 %.127.044
  %.226 = load i64, ptr %.225, align 8
  %.229 = mul nsw i64 %.127.044, %arg.own
  %.231 = getelementptr double, ptr %arg.numbers, i64 %.229
  %.234.idx = shl i64 %.127.044, 6
  %.234 = getelementptr i8, ptr %arg.settings, i64 %.234.idx
  %.236 = getelementptr double, ptr %arg.edges, i64 %.226
  %.239 = getelementptr i8, ptr %.225, i64 8
  %.240 = load i64, ptr %.239, align 8
  %.241 = sub nsw i64 %.240, %.226
  %.243 = mul nsw i64 %.127.044, %.100
  %.245 = getelementptr double, ptr %arg.y, i64 %.243
  %.247 = mul nsw i64 %.127.044, %arg.length
  %.249 = getelementptr double, ptr %arg.Y, i64 %.247
  %.252.idx = mul i64 %.127.044, 24
  %.252 = getelementptr i8, ptr %arg.state, i64 %.252.idx
  %.255.idx = mul i64 %.127.044, 48
  %.255 = getelementptr i8, ptr %arg.counts, i64 %.255.idx
  %.257 = mul nsw i64 %.226, %.100
  %.259 = getelementptr double, ptr %arg.outputs, i64 %.257
  store i64 0, ptr %.343, align 8
  %.347 = call i32 @march.35(ptr nonnull %.343, ptr nonnull %excinfo.1, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.pos, ptr %.231, ptr %arg.drive_rows, ptr %arg.drive_columns, i64 %arg.blocks, ptr %arg.slot, ptr %arg.slots, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %arg.mass, i64 %arg.tested, ptr %arg.powers, ptr %arg.method, ptr %.234, ptr %.236, i64 %.241, i64 %arg.max_steps, ptr %.245, ptr %.249, ptr %.252, ptr %.255, ptr %.259, i64 -1, i64 0, ptr %arg.work, ptr %arg.work)
  switch i32 %.347, label %B64.if [
    i32 -2, label %B64.endif
    i32 0, label %B64.endif
  ]

B64.if:
  %.355 = icmp sgt i32 %.347, 0
  %.348 = load ptr, ptr %excinfo.1, align 8
  %.356 = select i1 %.355, ptr %.348, ptr undef
  store ptr %.356, ptr %excinfo, align 8
  br label %common.ret

B64.endif:
  %.199 = add nuw nsw i64 %.127.044, 1
  %.357 = load i64, ptr %.343, align 8
  %.368 = getelementptr i64, ptr %arg.status, i64 %.127.044
  store i64 %.357, ptr %.368, align 8
  %exitcond.not = icmp eq i64 %arg.count, %.199
  br i1 %exitcond.not, label %B584, label %B62.if
}

define internal i32 @march.35(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.pos, ptr noalias %arg.numbers, ptr noalias %arg.drive_rows, ptr noalias %arg.drive_columns, i64 %arg.blocks, ptr noalias %arg.own, ptr noalias %arg.slots, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.mass, i64 %arg.tested, ptr noalias %arg.powers, ptr noalias %arg.method, ptr noalias %arg.settings, ptr noalias %arg.edges, i64 %arg.edge_count, i64 %arg.max_steps, ptr noalias %arg.y, ptr noalias %arg.Y, ptr noalias %arg.state, ptr noalias %arg.counts, ptr noalias %arg.outputs, i64 %arg.most_recorded, i64 %arg.record_length, ptr noalias %arg.record, ptr noalias %arg.work) noinline {
entry:
  %.490 = alloca double, align 8
  store double 0.000000e+00, ptr %.490, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.546 = alloca ptr, align 8
  store ptr null, ptr %.546, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.599 = alloca ptr, align 8
  store ptr null, ptr %.599, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.630 = alloca i64, align 8
  store i64 0, ptr %.630, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.692 = alloca ptr, align 8
  store ptr null, ptr %.692, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.732 = alloca ptr, align 8
  store ptr null, ptr %.732, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.759 = alloca ptr, align 8
  store ptr null, ptr %.759, align 8
  %excinfo.7 = alloca ptr, align 8
  store ptr null, ptr %excinfo.7, align 8
  %.793 = alloca double, align 8
  store double 0.000000e+00, ptr %.793, align 8
  %excinfo.8 = alloca ptr, align 8
  store ptr null, ptr %excinfo.8, align 8
  %.828 = alloca double, align 8
  store double 0.000000e+00, ptr %.828, align 8
  %excinfo.9 = alloca ptr, align 8
  store ptr null, ptr %excinfo.9, align 8
  %.877 = alloca double, align 8
  store double 0.000000e+00, ptr %.877, align 8
  %excinfo.10 = alloca ptr, align 8
  store ptr null, ptr %excinfo.10, align 8
  %.1152 = alloca ptr, align 8
  store ptr null, ptr %.1152, align 8
  %excinfo.11 = alloca ptr, align 8
  store ptr null, ptr %excinfo.11, align 8
  %.1198 = alloca double, align 8
  store double 0.000000e+00, ptr %.1198, align 8
  %excinfo.12 = alloca ptr, align 8
  store ptr null, ptr %excinfo.12, align 8
  %.1341 = alloca ptr, align 8
  store ptr null, ptr %.1341, align 8
  %excinfo.15 = alloca ptr, align 8
  store ptr null, ptr %excinfo.15, align 8
  %.1469 = alloca double, align 8
  store double 0.000000e+00, ptr %.1469, align 8
  %excinfo.16 = alloca ptr, align 8
  store ptr null, ptr %excinfo.16, align 8
  %.1511 = alloca double, align 8
  store double 0.000000e+00, ptr %.1511, align 8
  %excinfo.17 = alloca ptr, align 8
  store ptr null, ptr %excinfo.17, align 8
  %.1566 = alloca double, align 8
  store double 0.000000e+00, ptr %.1566, align 8
  %excinfo.18 = alloca ptr, align 8
  store ptr null, ptr %excinfo.18, align 8
  %.1598 = alloca double, align 8
  store double 0.000000e+00, ptr %.1598, align 8
  %excinfo.19 = alloca ptr, align 8
  store ptr null, ptr %excinfo.19, align 8
  %.95 = load i64, ptr %arg.layout, align 8
  %.97 = getelementptr i8, ptr %arg.layout, i64 16
  %.98 = load i64, ptr %.97, align 8
  %.108.idx = shl i64 %.95, 6
  %.108 = getelementptr i8, ptr %arg.work, i64 %.108.idx
  %.111.idx = mul i64 %.95, 72
  %.111 = getelementptr i8, ptr %arg.work, i64 %.111.idx
  %.idx = mul i64 %.95, 80
  %0 = getelementptr i8, ptr %arg.work, i64 %.idx
  %.115 = getelementptr i8, ptr %0, i64 8
  %.idx173 = mul i64 %.95, 88
  %1 = getelementptr i8, ptr %arg.work, i64 %.idx173
  %.128 = getelementptr i8, ptr %1, i64 8
  %.idx174 = mul i64 %.95, 96
  %2 = getelementptr i8, ptr %arg.work, i64 %.idx174
  %.132 = getelementptr i8, ptr %2, i64 8
  %.142.idx = shl i64 %arg.blocks, 5
  %.142 = getelementptr i8, ptr %.132, i64 %.142.idx
  %.149.idx = shl i64 %arg.blocks, 4
  %.149 = getelementptr i8, ptr %.142, i64 %.149.idx
  %.154 = getelementptr double, ptr %.149, i64 %.98
  %.160 = getelementptr i8, ptr %arg.layout, i64 24
  %.161 = load i64, ptr %.160, align 8
  %3 = getelementptr double, ptr %.154, i64 %.98
  %4 = getelementptr i8, ptr %3, i64 8
  %.164 = getelementptr double, ptr %4, i64 %.161
  %.169 = getelementptr i8, ptr %arg.layout, i64 8
  %.170 = load i64, ptr %.169, align 8
  %5 = getelementptr double, ptr %.164, i64 %.170
  %.173 = getelementptr i8, ptr %5, i64 8
  %.178 = getelementptr i8, ptr %arg.layout, i64 48
  %.179 = load i64, ptr %.178, align 8
  %.181 = getelementptr double, ptr %.173, i64 %.179
  %6 = getelementptr double, ptr %arg.edges, i64 %arg.edge_count
  %.188 = getelementptr i8, ptr %6, i64 -8
  %.189 = load double, ptr %.188, align 8
  %.195 = load i64, ptr %arg.counts, align 8
  %.287272.not = icmp slt i64 %arg.max_steps, 1
  br i1 %.287272.not, label %B2860, label %B672.if.lr.ph

B672.if.lr.ph:
  %.429 = getelementptr i8, ptr %arg.state, i64 8
  %.571 = getelementptr i8, ptr %arg.counts, i64 32
  %.581 = getelementptr i8, ptr %arg.method, i64 1344
  %.592 = getelementptr i32, ptr %arg.lu_start, i64 %arg.blocks
  %.655 = getelementptr i8, ptr %arg.counts, i64 8
  %.717 = getelementptr i8, ptr %arg.counts, i64 24
  %.727.idx = mul i64 %.95, 56
  %.727 = getelementptr i8, ptr %arg.work, i64 %.727.idx
  %.784 = getelementptr i8, ptr %arg.settings, i64 8
  %.1191 = getelementptr i8, ptr %arg.state, i64 16
  %.1194 = getelementptr i8, ptr %arg.method, i64 1352
  %.1562 = getelementptr i8, ptr %arg.settings, i64 16
  %.865 = getelementptr i8, ptr %arg.counts, i64 16
  %.873 = getelementptr i8, ptr %arg.method, i64 1352
  %.914 = getelementptr i8, ptr %arg.settings, i64 24
  %.429.promoted = load double, ptr %.429, align 8
  %7 = add i64 %arg.edge_count, -1
  br label %B672.if

common.ret:
  %common.ret.op = phi i32 [ %.1604, %B2728.endif.if ], [ 0, %B1748 ], [ 0, %B2860 ], [ %.1517, %B2600.endif.endif.if ], [ %.1572, %B2728.if ], [ %.496, %B818.endif.if ], [ %.550, %B860.if ], [ %.603, %B966.endif.if ], [ %.634, %B966.endif.endif.if ], [ %.696, %B1176.if ], [ %.736, %B1176.endif.if ], [ %.763, %B1176.endif.endif.if ], [ %.799, %B1176.endif.endif.endif.endif.if ], [ %.832, %B1176.endif.endif.endif.endif.endif.if ], [ %.881, %B1570.if ], [ %.1156, %B1942.if ], [ %.1202, %B2156.if ], [ %.1475, %B2600.if ], [ 0, %B2600.endif.endif.endif ], [ %.1345, %B2542.if ]
  ret i32 %common.ret.op

B800:
  %.475 = fmul contract double %.439, 5.000000e-01
  %.477 = fcmp contract ogt double %.430275, %.475
  br i1 %.477, label %B818, label %B856

B818:
  store double 0.000000e+00, ptr %.490, align 8
  %.496 = call i32 @numba.21(ptr nonnull %.490, ptr nonnull %excinfo.1, double %.430275, double %.475)
  switch i32 %.496, label %B818.endif.if [
    i32 -2, label %B818.endif.endif
    i32 0, label %B818.endif.endif
  ]

B856:
  %h.3.1 = phi double [ %.430275, %B800 ], [ %.506, %B818.endif.endif ], [ %.439, %B672.if ]
  br i1 %fresh.3.0274, label %B966, label %B860

B860:
  store ptr null, ptr %.546, align 8
  %.550 = call i32 @linearise.22(ptr nonnull %.546, ptr nonnull %excinfo.2, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.pos, ptr %arg.numbers, ptr %arg.drive_rows, ptr %arg.drive_columns, double %.427, ptr %arg.y, ptr %arg.Y, ptr %.154, ptr %.164, ptr %.128, ptr %.173, ptr %.181)
  switch i32 %.550, label %B860.if [
    i32 -2, label %B860.endif
    i32 0, label %B860.endif
  ]

B966:
  %.582 = load double, ptr %.581, align 8
  %.584 = fmul contract double %h.3.1, %.582
  %.588 = fdiv contract double 1.000000e+00, %.584
  %.593 = load i32, ptr %.592, align 4
  store ptr null, ptr %.599, align 8
  %.603 = call i32 @lu_fill.23(ptr nonnull %.599, ptr nonnull %excinfo.3, i64 %.95, i32 %.593, ptr %.154, ptr %arg.own, ptr %arg.mass, double %.588, ptr %.149)
  switch i32 %.603, label %B966.endif.if [
    i32 -2, label %B966.endif.endif
    i32 0, label %B966.endif.endif
  ]

B1176:
  store ptr null, ptr %.692, align 8
  %.696 = call i32 @solve_stages.24(ptr nonnull %.692, ptr nonnull %excinfo.5, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, i64 %arg.blocks, ptr %arg.slots, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %arg.mass, ptr %arg.method, double %.427, double %h.3.1, ptr %arg.y, ptr %arg.Y, ptr %.128, ptr %.149, ptr %arg.work, ptr %.108, i64 0, ptr %.111, ptr %.115, ptr %.142, ptr %.173, ptr %.181)
  switch i32 %.696, label %B1176.if [
    i32 -2, label %B1176.endif
    i32 0, label %B1176.endif
  ]

B1558:
  %error.2.1 = phi double [ %.842, %B1176.endif.endif.endif.endif.endif.endif ], [ 0x7FF0000000000000, %B966.endif.endif.endif ]
  %.856 = fcmp contract ugt double %error.2.1, 1.000000e+00
  br i1 %.856, label %B1570, label %B1770

B1570:
  %.866 = load i64, ptr %.865, align 8
  %.867 = add nsw i64 %.866, 1
  store i64 %.867, ptr %.865, align 8
  %.874 = load double, ptr %.873, align 8
  store double 0.000000e+00, ptr %.877, align 8
  %.881 = call i32 @step_factor.25(ptr nonnull %.877, ptr nonnull %excinfo.10, double %error.2.1, double 1.000000e+00, double %.874, ptr %arg.settings)
  switch i32 %.881, label %B1570.if [
    i32 -2, label %B1570.endif
    i32 0, label %B1570.endif
  ]

B1748:
  store i64 2, ptr %retptr, align 8
  br label %common.ret

B1770:
  %.1031 = fadd contract double %.427, %h.3.1
  %until.2.1 = select i1 %.446, double %.189, double %.1031
  %.1043 = load i64, ptr %arg.counts, align 8
  %.1053 = icmp slt i64 %.1043, %arg.edge_count
  br i1 %.1053, label %B1826, label %B1908

B1826:
  %.1064 = getelementptr double, ptr %arg.edges, i64 %.1043
  %.1065 = load double, ptr %.1064, align 8
  %.1069 = fmul contract double %until.2.1, 0x3FF0000000000005
  %.1070 = fcmp contract ugt double %.1065, %.1069
  br i1 %.1070, label %B1908, label %B1856

B1856:
  %stop.2.1 = phi i64 [ %.1076, %B1878 ], [ %.1043, %B1826 ]
  %exitcond.not = icmp eq i64 %stop.2.1, %7
  br i1 %exitcond.not, label %B1908, label %B1878

B1878:
  %.1076 = add nsw i64 %stop.2.1, 1
  %.1097 = getelementptr double, ptr %arg.edges, i64 %.1076
  %.1098 = load double, ptr %.1097, align 8
  %.1103 = fcmp contract ugt double %.1098, %.1069
  br i1 %.1103, label %B1908, label %B1856

B1908:
  %stop.3.2 = phi i64 [ %.1043, %B1826 ], [ %.1043, %B1770 ], [ %arg.edge_count, %B1856 ], [ %.1076, %B1878 ]
  %.1120 = icmp sgt i64 %stop.3.2, %.1043
  br i1 %.1120, label %B1942, label %B2156

B1942:
  %.1127 = getelementptr double, ptr %arg.edges, i64 %.1043
  %.1132 = sub nsw i64 %stop.3.2, %.1043
  %.1137 = sub nsw i64 %.1043, %.195
  %.1139 = mul nsw i64 %.1137, %.95
  %.1141 = getelementptr double, ptr %arg.outputs, i64 %.1139
  store ptr null, ptr %.1152, align 8
  %.1156 = call i32 @dense_output.26(ptr nonnull %.1152, ptr nonnull %excinfo.11, i64 %.95, ptr %arg.y, ptr %.115, ptr %arg.work, ptr %arg.method, double %.427, double %until.2.1, ptr %.1127, i64 %.1132, ptr %.1141, ptr %.111, ptr %.132, ptr %.142)
  switch i32 %.1156, label %B1942.if [
    i32 -2, label %B1942.endif
    i32 0, label %B1942.endif
  ]

B2156:
  %.1192 = load double, ptr %.1191, align 8
  %.1195 = load double, ptr %.1194, align 8
  store double 0.000000e+00, ptr %.1198, align 8
  %.1202 = call i32 @step_factor.25(ptr nonnull %.1198, ptr nonnull %excinfo.12, double %error.2.1, double %.1192, double %.1195, ptr %arg.settings)
  %.1212 = load double, ptr %.1198, align 8
  switch i32 %.1202, label %B2156.if [
    i32 -2, label %B2156.endif
    i32 0, label %B2156.endif
  ]

B2600:
  store double 0.000000e+00, ptr %.1469, align 8
  %.1475 = call i32 @numba.28(ptr nonnull %.1469, ptr nonnull %excinfo.16, double %.430275, double %h.3.1)
  %.1485 = load double, ptr %.1469, align 8
  switch i32 %.1475, label %B2600.if [
    i32 -2, label %B2600.endif
    i32 0, label %B2600.endif
  ]

B2728:
  %.1556 = fmul contract double %h.3.1, %.1212
  %.1563 = load double, ptr %.1562, align 8
  store double 0.000000e+00, ptr %.1566, align 8
  %.1572 = call i32 @numba.21(ptr nonnull %.1566, ptr nonnull %excinfo.18, double %.1556, double %.1563)
  switch i32 %.1572, label %B2728.if [
    i32 -2, label %B2728.endif
    i32 0, label %B2728.endif
  ]

B2860:
  store i64 1, ptr %retptr, align 8
  br label %common.ret

B2861:
  %.430276 = phi double [ %.904, %B1570.endif ], [ %.1582, %B2728.endif.endif ]
  %.287 = icmp sgt i64 %.231.0273, 1
  br i1 %.287, label %B672.if, label %B2860

B672.if:
  %.430275 = phi double [ %.429.promoted, %B672.if.lr.ph ], [ %.430276, %B2861 ]
  %fresh.3.0274 = phi i1 [ false, %B672.if.lr.ph ], [ %.856, %B2861 ]
  %.231.0273 = phi i64 [ %arg.max_steps, %B672.if.lr.ph ], [ %.296, %B2861 ]
  %.296 = add nsw i64 %.231.0273, -1
  %.427 = load double, ptr %arg.state, align 8
  %.439 = fsub contract double %.189, %.427
  %.444 = fmul contract double %.439, 0x3FEFFFFFFF768FA1
  %.446 = fcmp contract oge double %.430275, %.444
  br i1 %.446, label %B856, label %B800

B818.endif.if:
  %.504 = icmp sgt i32 %.496, 0
  %.497 = load ptr, ptr %excinfo.1, align 8
  %.505 = select i1 %.504, ptr %.497, ptr undef
  store ptr %.505, ptr %excinfo, align 8
  br label %common.ret

B818.endif.endif:
  %.506 = load double, ptr %.490, align 8
  br label %B856

B860.if:
  %.558 = icmp sgt i32 %.550, 0
  %.551 = load ptr, ptr %excinfo.2, align 8
  %.559 = select i1 %.558, ptr %.551, ptr undef
  store ptr %.559, ptr %excinfo, align 8
  br label %common.ret

B860.endif:
  %.572 = load i64, ptr %.571, align 8
  %.573 = add nsw i64 %.572, 1
  store i64 %.573, ptr %.571, align 8
  br label %B966

B966.endif.if:
  %.611 = icmp sgt i32 %.603, 0
  %.604 = load ptr, ptr %excinfo.3, align 8
  %.612 = select i1 %.611, ptr %.604, ptr undef
  store ptr %.612, ptr %excinfo, align 8
  br label %common.ret

B966.endif.endif:
  store i64 0, ptr %.630, align 8
  %.634 = call i32 @lu_factor.17(ptr nonnull %.630, ptr nonnull %excinfo.4, i64 %arg.blocks, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %.149, ptr %.132)
  switch i32 %.634, label %B966.endif.endif.if [
    i32 -2, label %B966.endif.endif.endif
    i32 0, label %B966.endif.endif.endif
  ]

B966.endif.endif.if:
  %.642 = icmp sgt i32 %.634, 0
  %.635 = load ptr, ptr %excinfo.4, align 8
  %.643 = select i1 %.642, ptr %.635, ptr undef
  store ptr %.643, ptr %excinfo, align 8
  br label %common.ret

B966.endif.endif.endif:
  %.644 = load i64, ptr %.630, align 8
  %.656 = load i64, ptr %.655, align 8
  %.657 = add nsw i64 %.656, 1
  store i64 %.657, ptr %.655, align 8
  %.664 = icmp eq i64 %.644, 0
  br i1 %.664, label %B1176, label %B1558

B1176.if:
  %.704 = icmp sgt i32 %.696, 0
  %.697 = load ptr, ptr %excinfo.5, align 8
  %.705 = select i1 %.704, ptr %.697, ptr undef
  store ptr %.705, ptr %excinfo, align 8
  br label %common.ret

B1176.endif:
  %.718 = load i64, ptr %.717, align 8
  %.719 = add nsw i64 %.718, 8
  store i64 %.719, ptr %.717, align 8
  store ptr null, ptr %.732, align 8
  %.736 = call i32 @copy.27(ptr nonnull %.732, ptr nonnull %excinfo.6, i64 %.95, ptr %.108, ptr %.115)
  switch i32 %.736, label %B1176.endif.if [
    i32 -2, label %B1176.endif.endif
    i32 0, label %B1176.endif.endif
  ]

B1176.endif.if:
  %.744 = icmp sgt i32 %.736, 0
  %.737 = load ptr, ptr %excinfo.6, align 8
  %.745 = select i1 %.744, ptr %.737, ptr undef
  store ptr %.745, ptr %excinfo, align 8
  br label %common.ret

B1176.endif.endif:
  store ptr null, ptr %.759, align 8
  %.763 = call i32 @add_scaled.29(ptr nonnull %.759, ptr nonnull %excinfo.7, i64 %.95, double 1.000000e+00, ptr %.727, ptr %.115)
  switch i32 %.763, label %B1176.endif.endif.if [
    i32 -2, label %B1176.endif.endif.endif
    i32 0, label %B1176.endif.endif.endif
  ]

B1176.endif.endif.if:
  %.771 = icmp sgt i32 %.763, 0
  %.764 = load ptr, ptr %excinfo.7, align 8
  %.772 = select i1 %.771, ptr %.764, ptr undef
  store ptr %.772, ptr %excinfo, align 8
  br label %common.ret

B1176.endif.endif.endif:
  %.785 = load double, ptr %.784, align 8
  %.790 = fdiv contract double %h.3.1, %.785
  store double 0.000000e+00, ptr %.793, align 8
  %.799 = call i32 @numba.21(ptr nonnull %.793, ptr nonnull %excinfo.8, double 1.000000e+00, double %.790)
  switch i32 %.799, label %B1176.endif.endif.endif.endif.if [
    i32 -2, label %B1176.endif.endif.endif.endif.endif
    i32 0, label %B1176.endif.endif.endif.endif.endif
  ]

B1176.endif.endif.endif.endif.if:
  %.807 = icmp sgt i32 %.799, 0
  %.800 = load ptr, ptr %excinfo.8, align 8
  %.808 = select i1 %.807, ptr %.800, ptr undef
  store ptr %.808, ptr %excinfo, align 8
  br label %common.ret

B1176.endif.endif.endif.endif.endif:
  %.809 = load double, ptr %.793, align 8
  %.822 = load double, ptr %arg.settings, align 8
  store double 0.000000e+00, ptr %.828, align 8
  %.832 = call i32 @step_error.30(ptr nonnull %.828, ptr nonnull %excinfo.9, i64 %.95, i64 %arg.tested, ptr %arg.y, ptr %.115, ptr %.727, ptr %arg.powers, double %.809, double %.822)
  switch i32 %.832, label %B1176.endif.endif.endif.endif.endif.if [
    i32 -2, label %B1176.endif.endif.endif.endif.endif.endif
    i32 0, label %B1176.endif.endif.endif.endif.endif.endif
  ]

B1176.endif.endif.endif.endif.endif.if:
  %.840 = icmp sgt i32 %.832, 0
  %.833 = load ptr, ptr %excinfo.9, align 8
  %.841 = select i1 %.840, ptr %.833, ptr undef
  store ptr %.841, ptr %excinfo, align 8
  br label %common.ret

B1176.endif.endif.endif.endif.endif.endif:
  %.842 = load double, ptr %.828, align 8
  br label %B1558

B1570.if:
  %.889 = icmp sgt i32 %.881, 0
  %.882 = load ptr, ptr %excinfo.10, align 8
  %.890 = select i1 %.889, ptr %.882, ptr undef
  store ptr %.890, ptr %excinfo, align 8
  br label %common.ret

B1570.endif:
  %.891 = load double, ptr %.877, align 8
  %.904 = fmul contract double %h.3.1, %.891
  store double %.904, ptr %.429, align 8
  %.915 = load double, ptr %.914, align 8
  %.916 = fcmp contract olt double %.904, %.915
  br i1 %.916, label %B1748, label %B2861

B1942.if:
  %.1164 = icmp sgt i32 %.1156, 0
  %.1157 = load ptr, ptr %excinfo.11, align 8
  %.1165 = select i1 %.1164, ptr %.1157, ptr undef
  store ptr %.1165, ptr %excinfo, align 8
  br label %common.ret

B1942.endif:
  store i64 %stop.3.2, ptr %arg.counts, align 8
  br label %B2156

B2156.if:
  %.1210 = icmp sgt i32 %.1202, 0
  %.1203 = load ptr, ptr %excinfo.12, align 8
  %.1211 = select i1 %.1210, ptr %.1203, ptr undef
  store ptr %.1211, ptr %excinfo, align 8
  br label %common.ret

B2156.endif:
  store ptr null, ptr %.1341, align 8
  %.1345 = call i32 @copy.27(ptr nonnull %.1341, ptr nonnull %excinfo.15, i64 %.95, ptr %.115, ptr %arg.y)
  switch i32 %.1345, label %B2542.if [
    i32 -2, label %B2542.endif
    i32 0, label %B2542.endif
  ]

B2542.if:
  %.1353 = icmp sgt i32 %.1345, 0
  %.1346 = load ptr, ptr %excinfo.15, align 8
  %.1354 = select i1 %.1353, ptr %.1346, ptr undef
  store ptr %.1354, ptr %excinfo, align 8
  br label %common.ret

B2542.endif:
  store double %until.2.1, ptr %arg.state, align 8
  br i1 %.446, label %B2600, label %B2728

B2600.if:
  %.1483 = icmp sgt i32 %.1475, 0
  %.1476 = load ptr, ptr %excinfo.16, align 8
  %.1484 = select i1 %.1483, ptr %.1476, ptr undef
  store ptr %.1484, ptr %excinfo, align 8
  br label %common.ret

B2600.endif:
  %.1500 = getelementptr i8, ptr %arg.settings, i64 32
  %.1501 = load double, ptr %.1500, align 8
  %.1507 = fdiv contract double 1.000000e+00, %.1501
  store double 0.000000e+00, ptr %.1511, align 8
  %.1517 = call i32 @numba.21(ptr nonnull %.1511, ptr nonnull %excinfo.17, double %.1212, double %.1507)
  switch i32 %.1517, label %B2600.endif.endif.if [
    i32 -2, label %B2600.endif.endif.endif
    i32 0, label %B2600.endif.endif.endif
  ]

B2600.endif.endif.if:
  %.1525 = icmp sgt i32 %.1517, 0
  %.1518 = load ptr, ptr %excinfo.17, align 8
  %.1526 = select i1 %.1525, ptr %.1518, ptr undef
  store ptr %.1526, ptr %excinfo, align 8
  br label %common.ret

B2600.endif.endif.endif:
  %.1527 = load double, ptr %.1511, align 8
  %.1539 = fmul contract double %.1485, %.1527
  store double %.1539, ptr %.429, align 8
  store i64 0, ptr %retptr, align 8
  br label %common.ret

B2728.if:
  %.1580 = icmp sgt i32 %.1572, 0
  %.1573 = load ptr, ptr %excinfo.18, align 8
  %.1581 = select i1 %.1580, ptr %.1573, ptr undef
  store ptr %.1581, ptr %excinfo, align 8
  br label %common.ret

B2728.endif:
  %.1582 = load double, ptr %.1566, align 8
  store double %.1582, ptr %.429, align 8
  store double 0.000000e+00, ptr %.1598, align 8
  %.1604 = call i32 @numba.28(ptr nonnull %.1598, ptr nonnull %excinfo.19, double %error.2.1, double 1.000000e-04)
  switch i32 %.1604, label %B2728.endif.if [
    i32 -2, label %B2728.endif.endif
    i32 0, label %B2728.endif.endif
  ]

B2728.endif.if:
  %.1612 = icmp sgt i32 %.1604, 0
  %.1605 = load ptr, ptr %excinfo.19, align 8
  %.1613 = select i1 %.1612, ptr %.1605, ptr undef
  store ptr %.1613, ptr %excinfo, align 8
  br label %common.ret

B2728.endif.endif:
  %.1614 = load double, ptr %.1598, align 8
  store double %.1614, ptr %.1191, align 8
  br label %B2861
}

define i64 @lu_solve_transposed(i64 %a0, ptr %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @lu_solve_transposed.36(ptr nonnull %r, ptr nonnull %e, i64 %a0, ptr %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9)
  ret i64 0
}

define internal i32 @lu_solve_transposed.36(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.slots, i64 %arg.blocks, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.lu, ptr noalias %arg.right, ptr noalias %arg.solution, ptr noalias %arg.x) noinline {
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
  %1 = call i32 @lu_solve_sides.37(ptr nonnull %r, ptr nonnull %e, i64 %a0, ptr %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9)
  ret i64 0
}

define internal i32 @lu_solve_sides.37(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.slots, i64 %arg.blocks, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.lu, ptr noalias %arg.right, ptr noalias %arg.solution, ptr noalias %arg.x) noinline {
entry:
  %.564 = alloca ptr, align 8
  store ptr null, ptr %.564, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.740 = alloca ptr, align 8
  store ptr null, ptr %.740, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %0 = call i64 @llvm.smax.i64(i64 %arg.blocks, i64 0)
  %storemerge = shl i64 %0, 4
  %.118298 = icmp sgt i64 %storemerge, 0
  br i1 %.118298, label %B56.if.preheader, label %B72

B56.if.preheader:
  %1 = shl i64 %0, 7
  call void @llvm.memset.p0.i64(ptr align 8 %arg.x, i8 0, i64 %1, i1 false)
  br label %B72

B72:
  %.244303.not = icmp slt i64 %arg.n, 1
  br i1 %.244303.not, label %B232, label %B102.if

B232:
  %.512306.not = icmp slt i64 %arg.blocks, 1
  br i1 %.512306.not, label %B386, label %B262.if

B386:
  %.676312.not = icmp slt i64 %arg.blocks, 1
  br i1 %.676312.not, label %B896.preheader, label %B426.if

B426.loopexit:
  %.676 = icmp sgt i64 %.623.0313, 1
  br i1 %.676, label %B426.if, label %B896.preheader

B896.preheader:
  %.1058317.not = icmp slt i64 %arg.n, 1
  br i1 %.1058317.not, label %B1026, label %B896.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B1026 ], [ %.744, %B428.if ], [ %.568, %B264.if ]
  ret i32 %common.ret.op

B1026:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B102.if:
  %.188.0304 = phi i64 [ %.257, %B102.if ], [ 0, %B72 ]
  %2 = shl i64 %.188.0304, 6
  %scevgep = getelementptr i8, ptr %arg.right, i64 %2
  %.410 = getelementptr i32, ptr %arg.slots, i64 %.188.0304
  %.411 = load i32, ptr %.410, align 4
  %.412 = sext i32 %.411 to i64
  %.idx297 = shl nsw i64 %.412, 6
  %3 = getelementptr i8, ptr %arg.x, i64 %.idx297
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 dereferenceable(64) %3, ptr nonnull align 8 dereferenceable(64) %scevgep, i64 64, i1 false)
  %.257 = add nuw nsw i64 %.188.0304, 1
  %exitcond.not = icmp eq i64 %arg.n, %.257
  br i1 %exitcond.not, label %B232, label %B102.if

B262.if:
  %.456.0307 = phi i64 [ %.525, %B264.endif ], [ 0, %B232 ]
  %.553.idx = shl i64 %.456.0307, 7
  %.553 = getelementptr i8, ptr %arg.x, i64 %.553.idx
  %.556 = getelementptr i32, ptr %arg.lu_start, i64 %.456.0307
  %.557 = load i32, ptr %.556, align 4
  %.559 = getelementptr i32, ptr %arg.diagonal, i64 %.456.0307
  %.560 = load i32, ptr %.559, align 4
  store ptr null, ptr %.564, align 8
  %.568 = call i32 @subtract_products.38(ptr nonnull %.564, ptr nonnull %excinfo.1, i32 %.557, i32 %.560, ptr %arg.lu, ptr %arg.lu_columns, ptr %arg.x, ptr %.553)
  switch i32 %.568, label %B264.if [
    i32 -2, label %B264.endif
    i32 0, label %B264.endif
  ]

B264.if:
  %.576 = icmp sgt i32 %.568, 0
  %.569 = load ptr, ptr %excinfo.1, align 8
  %.577 = select i1 %.576, ptr %.569, ptr undef
  store ptr %.577, ptr %excinfo, align 8
  br label %common.ret

B264.endif:
  %.525 = add nuw nsw i64 %.456.0307, 1
  %exitcond322.not = icmp eq i64 %arg.blocks, %.525
  br i1 %exitcond322.not, label %B386, label %B262.if

B426.if:
  %.620.0314.in = phi i64 [ %.620.0314, %B426.loopexit ], [ %arg.blocks, %B386 ]
  %.623.0313 = phi i64 [ %.685, %B426.loopexit ], [ %arg.blocks, %B386 ]
  %.620.0314 = add i64 %.620.0314.in, -1
  %.685 = add nsw i64 %.623.0313, -1
  %.717 = getelementptr i32, ptr %arg.diagonal, i64 %.620.0314
  %.718 = load i32, ptr %.717, align 4
  %.719 = sext i32 %.718 to i64
  %.726.idx = shl i64 %.620.0314, 7
  %.726 = getelementptr i8, ptr %arg.x, i64 %.726.idx
  %.732 = add nsw i64 %.719, 1
  %4 = getelementptr i32, ptr %arg.lu_start, i64 %.620.0314
  %.735 = getelementptr i8, ptr %4, i64 4
  %.736 = load i32, ptr %.735, align 4
  store ptr null, ptr %.740, align 8
  %.744 = call i32 @subtract_products.39(ptr nonnull %.740, ptr nonnull %excinfo.2, i64 %.732, i32 %.736, ptr %arg.lu, ptr %arg.lu_columns, ptr %arg.x, ptr %.726)
  switch i32 %.744, label %B428.if [
    i32 -2, label %B428.endif
    i32 0, label %B428.endif
  ]

B428.if:
  %.752 = icmp sgt i32 %.744, 0
  %.745 = load ptr, ptr %excinfo.2, align 8
  %.753 = select i1 %.752, ptr %.745, ptr undef
  store ptr %.753, ptr %excinfo, align 8
  br label %common.ret

B428.endif:
  %.765.idx = shl nsw i64 %.719, 5
  %.765 = getelementptr i8, ptr %arg.lu, i64 %.765.idx
  %.766 = load double, ptr %.765, align 8
  %.769 = getelementptr i8, ptr %.765, i64 8
  %.770 = load double, ptr %.769, align 8
  %.773 = getelementptr i8, ptr %.765, i64 16
  %.774 = load double, ptr %.773, align 8
  %.777 = getelementptr i8, ptr %.765, i64 24
  %.778 = load double, ptr %.777, align 8
  %5 = getelementptr i8, ptr %.726, i64 64
  br label %B714.if

B714.if:
  %.822.0309 = phi i64 [ 0, %B428.endif ], [ %.891, %B714.if ]
  %.891 = add nuw nsw i64 %.822.0309, 1
  %.919 = getelementptr double, ptr %.726, i64 %.822.0309
  %.920 = load double, ptr %.919, align 8
  %.925 = getelementptr double, ptr %5, i64 %.822.0309
  %.926 = load double, ptr %.925, align 8
  %.928 = fmul contract double %.766, %.920
  %.930 = fmul contract double %.770, %.926
  %.931 = fadd contract double %.928, %.930
  store double %.931, ptr %.919, align 8
  %.938 = fmul contract double %.774, %.920
  %.940 = fmul contract double %.778, %.926
  %.941 = fadd contract double %.938, %.940
  store double %.941, ptr %.925, align 8
  %exitcond323.not = icmp eq i64 %.891, 8
  br i1 %exitcond323.not, label %B426.loopexit, label %B714.if

B896.if:
  %.1002.0318 = phi i64 [ %.1071, %B896.if ], [ 0, %B896.preheader ]
  %6 = shl i64 %.1002.0318, 6
  %scevgep324 = getelementptr i8, ptr %arg.solution, i64 %6
  %.1218 = getelementptr i32, ptr %arg.slots, i64 %.1002.0318
  %.1219 = load i32, ptr %.1218, align 4
  %.1220 = sext i32 %.1219 to i64
  %.idx = shl nsw i64 %.1220, 6
  %7 = getelementptr i8, ptr %arg.x, i64 %.idx
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 dereferenceable(64) %scevgep324, ptr nonnull align 8 dereferenceable(64) %7, i64 64, i1 false)
  %.1071 = add nuw nsw i64 %.1002.0318, 1
  %exitcond325.not = icmp eq i64 %arg.n, %.1071
  br i1 %exitcond325.not, label %B1026, label %B896.if
}

define internal i32 @subtract_products.38(ptr noalias %retptr, ptr noalias %excinfo, i32 %arg.first, i32 %arg.last, ptr noalias %arg.lu, ptr noalias %arg.lu_columns, ptr noalias %arg.x, ptr noalias %arg.own) noinline {
entry:
  %.54 = sub i32 %arg.last, %arg.first
  %.9978.not = icmp slt i32 %.54, 1
  br i1 %.9978.not, label %B378, label %B36.if

B36.loopexit:
  %.108 = add nsw i32 %.44.080, -1
  %.112 = add i32 %.41.079, 1
  %.99 = icmp sgt i32 %.44.080, 1
  br i1 %.99, label %B36.if, label %B378

B378:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B36.if:
  %.44.080 = phi i32 [ %.108, %B36.loopexit ], [ %.54, %entry ]
  %.41.079 = phi i32 [ %.112, %B36.loopexit ], [ %arg.first, %entry ]
  %0 = sext i32 %.41.079 to i64
  %.141 = getelementptr i32, ptr %arg.lu_columns, i64 %0
  %.142 = load i32, ptr %.141, align 4
  %.143 = sext i32 %.142 to i64
  %.idx = shl nsw i64 %.143, 7
  %1 = getelementptr i8, ptr %arg.x, i64 %.idx
  %2 = getelementptr i8, ptr %1, i64 64
  %.285.idx = shl nsw i64 %0, 5
  %.285 = getelementptr i8, ptr %arg.lu, i64 %.285.idx
  %.286 = load double, ptr %.285, align 8
  %.291 = getelementptr i8, ptr %.285, i64 8
  %.292 = load double, ptr %.291, align 8
  %.306 = getelementptr i8, ptr %.285, i64 16
  %.307 = load double, ptr %.306, align 8
  %.312 = getelementptr i8, ptr %.285, i64 24
  %.313 = load double, ptr %.312, align 8
  br label %B128.if

B128.if:
  %.175.076 = phi i64 [ 0, %B36.if ], [ %.244, %B128.if ]
  %.244 = add nuw nsw i64 %.175.076, 1
  %.272 = getelementptr double, ptr %1, i64 %.175.076
  %.273 = load double, ptr %.272, align 8
  %.278 = getelementptr double, ptr %2, i64 %.175.076
  %.279 = load double, ptr %.278, align 8
  %.281 = getelementptr double, ptr %arg.own, i64 %.175.076
  %.282 = load double, ptr %.281, align 8
  %.287 = fmul contract double %.273, %.286
  %.293 = fmul contract double %.279, %.292
  %.294 = fadd contract double %.287, %.293
  %.295 = fsub contract double %.282, %.294
  store double %.295, ptr %.281, align 8
  %.301 = getelementptr i8, ptr %.281, i64 64
  %.302 = load double, ptr %.301, align 8
  %.308 = fmul contract double %.273, %.307
  %.314 = fmul contract double %.279, %.313
  %.315 = fadd contract double %.308, %.314
  %.316 = fsub contract double %.302, %.315
  store double %.316, ptr %.301, align 8
  %exitcond.not = icmp eq i64 %.244, 8
  br i1 %exitcond.not, label %B36.loopexit, label %B128.if
}

define internal i32 @subtract_products.39(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.first, i32 %arg.last, ptr noalias %arg.lu, ptr noalias %arg.lu_columns, ptr noalias %arg.x, ptr noalias %arg.own) noinline {
entry:
  %.18 = sext i32 %arg.last to i64
  %.55 = sub i64 %.18, %arg.first
  %.10078.not = icmp slt i64 %.55, 1
  br i1 %.10078.not, label %B378, label %B36.if

B36.loopexit:
  %.109 = add nsw i64 %.45.080, -1
  %.113 = add i64 %.42.079, 1
  %.100 = icmp sgt i64 %.45.080, 1
  br i1 %.100, label %B36.if, label %B378

B378:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B36.if:
  %.45.080 = phi i64 [ %.109, %B36.loopexit ], [ %.55, %entry ]
  %.42.079 = phi i64 [ %.113, %B36.loopexit ], [ %arg.first, %entry ]
  %.140 = getelementptr i32, ptr %arg.lu_columns, i64 %.42.079
  %.141 = load i32, ptr %.140, align 4
  %.142 = sext i32 %.141 to i64
  %.idx = shl nsw i64 %.142, 7
  %0 = getelementptr i8, ptr %arg.x, i64 %.idx
  %1 = getelementptr i8, ptr %0, i64 64
  %.284.idx = shl i64 %.42.079, 5
  %.284 = getelementptr i8, ptr %arg.lu, i64 %.284.idx
  %.285 = load double, ptr %.284, align 8
  %.290 = getelementptr i8, ptr %.284, i64 8
  %.291 = load double, ptr %.290, align 8
  %.305 = getelementptr i8, ptr %.284, i64 16
  %.306 = load double, ptr %.305, align 8
  %.311 = getelementptr i8, ptr %.284, i64 24
  %.312 = load double, ptr %.311, align 8
  br label %B128.if

B128.if:
  %.174.076 = phi i64 [ 0, %B36.if ], [ %.243, %B128.if ]
  %.243 = add nuw nsw i64 %.174.076, 1
  %.271 = getelementptr double, ptr %0, i64 %.174.076
  %.272 = load double, ptr %.271, align 8
  %.277 = getelementptr double, ptr %1, i64 %.174.076
  %.278 = load double, ptr %.277, align 8
  %.280 = getelementptr double, ptr %arg.own, i64 %.174.076
  %.281 = load double, ptr %.280, align 8
  %.286 = fmul contract double %.272, %.285
  %.292 = fmul contract double %.278, %.291
  %.293 = fadd contract double %.286, %.292
  %.294 = fsub contract double %.281, %.293
  store double %.294, ptr %.280, align 8
  %.300 = getelementptr i8, ptr %.280, i64 64
  %.301 = load double, ptr %.300, align 8
  %.307 = fmul contract double %.272, %.306
  %.313 = fmul contract double %.278, %.312
  %.314 = fadd contract double %.307, %.313
  %.315 = fsub contract double %.301, %.314
  store double %.315, ptr %.300, align 8
  %exitcond.not = icmp eq i64 %.243, 8
  br i1 %exitcond.not, label %B36.loopexit, label %B128.if
}

define i64 @slopes_at(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @slopes_at.40(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12)
  ret i64 0
}

define internal i32 @slopes_at.40(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.weights, ptr noalias %arg.Y_bar, ptr noalias %arg.numbers_bar, ptr noalias %arg.drive_weights, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
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
  %.49 = call i32 @pull_residual.41(ptr nonnull %.45, ptr nonnull %excinfo.2, ptr %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.weights, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %arg.local, ptr %arg.out)
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
  %.74 = call i32 @drives_bar.42(ptr nonnull %.70, ptr nonnull %excinfo.3, ptr %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %arg.drive_weights, ptr %arg.local, ptr %arg.out)
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

define internal i32 @pull_residual.41(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.weights, ptr noalias %arg.Y_bar, ptr noalias %arg.numbers_bar, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
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
  %.419 = call i32 @pull.43(ptr nonnull %.415, ptr nonnull %excinfo.1, ptr %arg.layout, i64 %1, i64 0, i64 %.396, ptr %.403, ptr %arg.derived, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.weights, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %arg.local, ptr %arg.out)
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

define internal i32 @drives_bar.42(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.Y_bar, ptr noalias %arg.numbers_bar, ptr noalias %arg.weights, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
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
  %.202 = call i32 @pull_drive.44(ptr nonnull %.198, ptr nonnull %excinfo.1, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, i64 0, ptr %arg.weights, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %arg.local, ptr %arg.out)
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

define internal i32 @pull_drive.44(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, i64 %arg.which, ptr noalias %arg.weights, ptr noalias %arg.Y_bar, ptr noalias %arg.numbers_bar, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
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
  %.194 = call i32 @pull.43(ptr nonnull %.190, ptr nonnull %excinfo.1, ptr %arg.layout, i64 %.167, i64 %arg.which, i64 %.172, ptr %.178, ptr %arg.derived, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.weights, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %arg.local, ptr %arg.out)
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

define internal i32 @pull.43(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, i64 %arg.table, i64 %arg.which, i64 %arg.results, ptr noalias %arg.places, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.weights, ptr noalias %arg.Y_bar, ptr noalias %arg.numbers_bar, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
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
  %1 = call i32 @rates_at.45(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9, ptr %a10, ptr %a11)
  ret i64 0
}

define internal i32 @rates_at.45(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.Y_dot, ptr noalias %arg.numbers_dot, ptr noalias %arg.r_dot, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
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
  %.51 = call i32 @push_drive.46(ptr nonnull %.47, ptr nonnull %excinfo.2, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, i64 0, ptr %arg.Y_dot, ptr %arg.numbers_dot, ptr %.18, ptr %arg.local, ptr %arg.out)
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
  %.76 = call i32 @push_residual.47(ptr nonnull %.72, ptr nonnull %excinfo.3, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.Y_dot, ptr %arg.numbers_dot, ptr %arg.r_dot, ptr %arg.local, ptr %arg.out)
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

define internal i32 @push_drive.46(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, i64 %arg.which, ptr noalias %arg.Y_dot, ptr noalias %arg.numbers_dot, ptr noalias %arg.rates_dot, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
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
  %.323 = call i32 @push.48(ptr nonnull %.319, ptr nonnull %excinfo.1, ptr %arg.layout, i64 %.167, i64 %arg.which, i64 %.213.0124, ptr %arg.derived, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.Y_dot, ptr %arg.numbers_dot, ptr %arg.local, ptr %arg.out)
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

define internal i32 @push_residual.47(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.Y_dot, ptr noalias %arg.numbers_dot, ptr noalias %arg.r_dot, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
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
  %.661 = call i32 @push.48(ptr nonnull %.657, ptr nonnull %excinfo.1, ptr nonnull %arg.layout, i64 %4, i64 0, i64 %.552.0166, ptr %arg.derived, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.Y_dot, ptr %arg.numbers_dot, ptr %arg.local, ptr %arg.out)
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

define internal i32 @push.48(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, i64 %arg.table, i64 %arg.which, i64 %arg.group, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.Y_dot, ptr noalias %arg.numbers_dot, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
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

define i64 @reverse(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, i64 %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, ptr %a14, i64 %a15, ptr %a16, ptr %a17, ptr %a18, ptr %a19, ptr %a20, ptr %a21, i64 %a22, i64 %a23, ptr %a24, i64 %a25, ptr %a26, ptr %a27, ptr %a28, ptr %a29, ptr %a30, ptr %a31, ptr %a32) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @reverse.49(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, i64 %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, ptr %a14, i64 %a15, ptr %a16, ptr %a17, ptr %a18, ptr %a19, ptr %a20, ptr %a21, i64 %a22, i64 %a23, ptr %a24, i64 %a25, ptr %a26, ptr %a27, ptr %a28, ptr %a29, ptr %a30, ptr %a31, ptr %a32)
  ret i64 0
}

define internal i32 @reverse.49(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.pos, ptr noalias %arg.numbers, ptr noalias %arg.drive_rows, ptr noalias %arg.drive_columns, i64 %arg.blocks, ptr noalias %arg.own, ptr noalias %arg.slots, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, i64 %arg.entry_count, ptr noalias %arg.entry_rows, ptr noalias %arg.entry_columns, ptr noalias %arg.entry_places, ptr noalias %arg.mass, ptr noalias %arg.method, ptr noalias %arg.record, i64 %arg.step_count, i64 %arg.step_length, ptr noalias %arg.edges, i64 %arg.edge_count, ptr noalias %arg.weights, ptr noalias %arg.Y, ptr noalias %arg.y_bar, ptr noalias %arg.Y_bar, ptr noalias %arg.numbers_bar, ptr noalias %arg.ends_bar, ptr noalias %arg.work) noinline {
entry:
  %.502 = alloca ptr, align 8
  store ptr null, ptr %.502, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.819 = alloca i64, align 8
  store i64 0, ptr %.819, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.976 = alloca double, align 8
  store double 0.000000e+00, ptr %.976, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.1013 = alloca ptr, align 8
  store ptr null, ptr %.1013, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.1042 = alloca ptr, align 8
  store ptr null, ptr %.1042, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.1186 = alloca double, align 8
  store double 0.000000e+00, ptr %.1186, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.1217 = alloca ptr, align 8
  store ptr null, ptr %.1217, align 8
  %excinfo.7 = alloca ptr, align 8
  store ptr null, ptr %excinfo.7, align 8
  %.1254 = alloca ptr, align 8
  store ptr null, ptr %.1254, align 8
  %excinfo.8 = alloca ptr, align 8
  store ptr null, ptr %excinfo.8, align 8
  %.1282 = alloca double, align 8
  store double 0.000000e+00, ptr %.1282, align 8
  %excinfo.9 = alloca ptr, align 8
  store ptr null, ptr %excinfo.9, align 8
  %.1365 = alloca ptr, align 8
  store ptr null, ptr %.1365, align 8
  %excinfo.10 = alloca ptr, align 8
  store ptr null, ptr %excinfo.10, align 8
  %.1547 = alloca ptr, align 8
  store ptr null, ptr %.1547, align 8
  %excinfo.11 = alloca ptr, align 8
  store ptr null, ptr %excinfo.11, align 8
  %.1579 = alloca ptr, align 8
  store ptr null, ptr %.1579, align 8
  %excinfo.12 = alloca ptr, align 8
  store ptr null, ptr %excinfo.12, align 8
  %.1625 = alloca ptr, align 8
  store ptr null, ptr %.1625, align 8
  %excinfo.13 = alloca ptr, align 8
  store ptr null, ptr %excinfo.13, align 8
  %.1780 = alloca ptr, align 8
  store ptr null, ptr %.1780, align 8
  %excinfo.14 = alloca ptr, align 8
  store ptr null, ptr %excinfo.14, align 8
  %.1820 = alloca ptr, align 8
  store ptr null, ptr %.1820, align 8
  %excinfo.15 = alloca ptr, align 8
  store ptr null, ptr %excinfo.15, align 8
  %.1856 = alloca ptr, align 8
  store ptr null, ptr %.1856, align 8
  %excinfo.16 = alloca ptr, align 8
  store ptr null, ptr %excinfo.16, align 8
  %.1888 = alloca ptr, align 8
  store ptr null, ptr %.1888, align 8
  %excinfo.17 = alloca ptr, align 8
  store ptr null, ptr %excinfo.17, align 8
  %.1917 = alloca ptr, align 8
  store ptr null, ptr %.1917, align 8
  %excinfo.18 = alloca ptr, align 8
  store ptr null, ptr %excinfo.18, align 8
  %.2244 = alloca ptr, align 8
  store ptr null, ptr %.2244, align 8
  %excinfo.19 = alloca ptr, align 8
  store ptr null, ptr %excinfo.19, align 8
  %.2278 = alloca ptr, align 8
  store ptr null, ptr %.2278, align 8
  %excinfo.20 = alloca ptr, align 8
  store ptr null, ptr %excinfo.20, align 8
  %.2316 = alloca double, align 8
  store double 0.000000e+00, ptr %.2316, align 8
  %excinfo.21 = alloca ptr, align 8
  store ptr null, ptr %excinfo.21, align 8
  %.2368 = alloca double, align 8
  store double 0.000000e+00, ptr %.2368, align 8
  %excinfo.22 = alloca ptr, align 8
  store ptr null, ptr %excinfo.22, align 8
  %.2407 = alloca double, align 8
  store double 0.000000e+00, ptr %.2407, align 8
  %excinfo.23 = alloca ptr, align 8
  store ptr null, ptr %excinfo.23, align 8
  %.2448 = alloca ptr, align 8
  store ptr null, ptr %.2448, align 8
  %excinfo.24 = alloca ptr, align 8
  store ptr null, ptr %excinfo.24, align 8
  %.3203 = alloca ptr, align 8
  store ptr null, ptr %.3203, align 8
  %excinfo.25 = alloca ptr, align 8
  store ptr null, ptr %excinfo.25, align 8
  %.3245 = alloca ptr, align 8
  store ptr null, ptr %.3245, align 8
  %excinfo.26 = alloca ptr, align 8
  store ptr null, ptr %excinfo.26, align 8
  %.3408 = alloca ptr, align 8
  store ptr null, ptr %.3408, align 8
  %excinfo.27 = alloca ptr, align 8
  store ptr null, ptr %excinfo.27, align 8
  %.3444 = alloca ptr, align 8
  store ptr null, ptr %.3444, align 8
  %excinfo.28 = alloca ptr, align 8
  store ptr null, ptr %excinfo.28, align 8
  %.3480 = alloca ptr, align 8
  store ptr null, ptr %.3480, align 8
  %excinfo.29 = alloca ptr, align 8
  store ptr null, ptr %excinfo.29, align 8
  %.3519 = alloca ptr, align 8
  store ptr null, ptr %.3519, align 8
  %excinfo.30 = alloca ptr, align 8
  store ptr null, ptr %excinfo.30, align 8
  %.3547 = alloca ptr, align 8
  store ptr null, ptr %.3547, align 8
  %excinfo.31 = alloca ptr, align 8
  store ptr null, ptr %excinfo.31, align 8
  %.101 = load i64, ptr %arg.layout, align 8
  %.103 = getelementptr i8, ptr %arg.layout, i64 16
  %.104 = load i64, ptr %.103, align 8
  %.112 = getelementptr i8, ptr %arg.layout, i64 8
  %.113 = load i64, ptr %.112, align 8
  %.117 = getelementptr i8, ptr %arg.layout, i64 24
  %.118 = load i64, ptr %.117, align 8
  %.126 = add i64 %.104, 1
  %.128 = add i64 %.118, %.126
  %.134 = shl nsw i64 %.101, 3
  %.135 = getelementptr double, ptr %arg.work, i64 %.134
  %.144.idx = mul i64 %.101, 136
  %.144 = getelementptr i8, ptr %arg.work, i64 %.144.idx
  %.147.idx = mul i64 %.101, 200
  %.147 = getelementptr i8, ptr %arg.work, i64 %.147.idx
  %.156.idx = mul i64 %.101, 264
  %.156 = getelementptr i8, ptr %arg.work, i64 %.156.idx
  %.idx = mul i64 %.101, 272
  %0 = getelementptr i8, ptr %arg.work, i64 %.idx
  %.160 = getelementptr i8, ptr %0, i64 8
  %.idx651 = mul i64 %.101, 280
  %1 = getelementptr i8, ptr %arg.work, i64 %.idx651
  %.164 = getelementptr i8, ptr %1, i64 8
  %.idx652 = mul i64 %.101, 288
  %2 = getelementptr i8, ptr %arg.work, i64 %.idx652
  %.177 = getelementptr i8, ptr %2, i64 8
  %.idx653 = mul i64 %.101, 296
  %3 = getelementptr i8, ptr %arg.work, i64 %.idx653
  %.181 = getelementptr i8, ptr %3, i64 8
  %.idx654 = mul i64 %.101, 304
  %4 = getelementptr i8, ptr %arg.work, i64 %.idx654
  %.191 = getelementptr i8, ptr %4, i64 8
  %.198.idx = shl i64 %arg.blocks, 5
  %.198 = getelementptr i8, ptr %.191, i64 %.198.idx
  %.205.idx = shl i64 %arg.blocks, 4
  %.205 = getelementptr i8, ptr %.198, i64 %.205.idx
  %.211 = getelementptr double, ptr %.205, i64 %.104
  %.217 = getelementptr double, ptr %.211, i64 %.128
  %.223 = getelementptr double, ptr %.217, i64 %.128
  %.230 = add nsw i64 %.113, 1
  %.232 = getelementptr double, ptr %.223, i64 %.230
  %.241 = getelementptr double, ptr %.232, i64 %.230
  %.246 = getelementptr i8, ptr %arg.layout, i64 56
  %.247 = load i64, ptr %.246, align 8
  %.249 = getelementptr double, ptr %.241, i64 %.247
  %.339954 = icmp sgt i64 %arg.step_count, 0
  br i1 %.339954, label %B918.lr.ph, label %B4378

B918.lr.ph:
  %.283.1957 = add nsw i64 %arg.step_count, -1
  %.115 = add i64 %.113, %.101
  %.381 = add nsw i64 %arg.step_count, -1
  %.529 = getelementptr double, ptr %.135, i64 %.134
  %.582 = icmp sgt i64 %.101, 0
  %storemerge655 = select i1 %.582, i64 %.134, i64 0
  %.624905 = icmp sgt i64 %storemerge655, 0
  %.1362.idx = mul i64 %.101, 56
  %.1362 = getelementptr i8, ptr %.144, i64 %.1362.idx
  %.1390 = getelementptr i8, ptr %arg.method, i64 1344
  %.1614 = getelementptr double, ptr %arg.Y, i64 %.115
  %5 = call i64 @llvm.smax.i64(i64 %.115, i64 -1)
  %storemerge663 = add i64 %5, 1
  %.1730919 = icmp sgt i64 %.115, -1
  %.1806 = getelementptr double, ptr %.156, i64 %.101
  %.1948 = getelementptr double, ptr %arg.Y_bar, i64 %.115
  %.2049922.not = icmp slt i64 %.101, 1
  %storemerge658 = call i64 @llvm.smax.i64(i64 %.128, i64 0)
  %.2563934.not = icmp slt i64 %.128, 1
  %.2689942.not = icmp slt i64 %arg.entry_count, 1
  %.3109948.not = icmp slt i64 %.118, 1
  %.3232 = getelementptr double, ptr %arg.Y, i64 %.115
  %.3350951 = icmp sgt i64 %.115, -1
  %.3506 = getelementptr double, ptr %arg.Y_bar, i64 %.115
  %.3575 = getelementptr i8, ptr %arg.ends_bar, i64 8
  %6 = shl nuw i64 %storemerge655, 3
  %7 = add i64 %5, 2
  %smin = call i64 @llvm.smin.i64(i64 %storemerge663, i64 1)
  %8 = sub i64 %7, %smin
  %9 = shl nuw i64 %8, 3
  %10 = mul i64 %arg.blocks, 48
  %11 = shl i64 %.104, 4
  %12 = shl i64 %.118, 3
  %13 = getelementptr i8, ptr %arg.work, i64 %.idx654
  %14 = getelementptr i8, ptr %13, i64 %10
  %15 = getelementptr i8, ptr %14, i64 %11
  %16 = getelementptr i8, ptr %15, i64 %12
  %scevgep = getelementptr i8, ptr %16, i64 16
  %17 = shl nuw i64 %storemerge658, 3
  %18 = mul i64 %arg.blocks, 48
  %19 = mul i64 %.104, 24
  %20 = shl i64 %.118, 4
  %21 = shl i64 %.113, 3
  %22 = getelementptr i8, ptr %arg.work, i64 %.idx654
  %23 = getelementptr i8, ptr %22, i64 %18
  %24 = getelementptr i8, ptr %23, i64 %19
  %25 = getelementptr i8, ptr %24, i64 %20
  %26 = getelementptr i8, ptr %25, i64 %21
  %scevgep1197 = getelementptr i8, ptr %26, i64 32
  %27 = add i64 %5, 2
  %smin1200 = call i64 @llvm.smin.i64(i64 %storemerge663, i64 1)
  %28 = sub i64 %27, %smin1200
  %29 = shl nuw i64 %28, 3
  br label %B918

B918:
  %.329.sroa.0.0961 = phi i64 [ 0, %B918.lr.ph ], [ %.329.sroa.0.0, %B4374 ]
  %.283.1960 = phi i64 [ %.283.1957, %B918.lr.ph ], [ %.283.1, %B4374 ]
  %.280.1959 = phi i64 [ 1, %B918.lr.ph ], [ %.280.1, %B4374 ]
  %stop.2.0958 = phi i64 [ %arg.edge_count, %B918.lr.ph ], [ %.833, %B4374 ]
  %.383 = sub nsw i64 %.381, %.329.sroa.0.0961
  %.385 = mul nsw i64 %.383, %arg.step_length
  %.387 = getelementptr double, ptr %arg.record, i64 %.385
  %.393 = load double, ptr %.387, align 8
  %.395 = getelementptr i8, ptr %.387, i64 8
  %.396 = load double, ptr %.395, align 8
  %.398 = getelementptr i8, ptr %.387, i64 24
  store ptr null, ptr %.502, align 8
  %.506 = call i32 @replay.50(ptr nonnull %.502, ptr nonnull %excinfo.1, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.pos, ptr %arg.numbers, ptr %arg.drive_rows, ptr %arg.drive_columns, i64 %arg.blocks, ptr %arg.own, ptr %arg.slots, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %arg.mass, ptr %arg.method, ptr nonnull %.387, i64 %arg.step_length, ptr %arg.Y, ptr %arg.work, ptr %.135, ptr %.211, ptr %.223, ptr %.164, ptr %.205, ptr %.156, ptr %.160, ptr %.191, ptr %.198, ptr %.241, ptr %.249)
  switch i32 %.506, label %B918.if [
    i32 -2, label %B918.endif
    i32 0, label %B918.endif
  ]

B1308:
  br i1 %.582, label %B1338.if, label %B1366

B1366:
  store i64 0, ptr %.819, align 8
  %.823 = call i32 @first_edge_in.51(ptr nonnull %.819, ptr nonnull %excinfo.2, ptr %arg.edges, i64 %stop.2.0958, double %.393)
  %.833 = load i64, ptr %.819, align 8
  switch i32 %.823, label %B1366.if [
    i32 -2, label %B1366.endif
    i32 0, label %B1366.endif
  ]

B1746:
  store ptr null, ptr %.1254, align 8
  %.1258 = call i32 @dense_rate.52(ptr nonnull %.1254, ptr nonnull %excinfo.8, i64 %.101, ptr %arg.method, double %.990, ptr %.398, ptr %.529, ptr %arg.work, ptr %.156)
  switch i32 %.1258, label %B1746.if [
    i32 -2, label %B1746.endif
    i32 0, label %B1746.endif
  ]

B1862:
  %h_bar.6.1.lcssa = phi double [ 0.000000e+00, %B1366.endif ], [ %.1318, %B1746.endif.endif ]
  %time_bar.4.1.lcssa = phi double [ 0.000000e+00, %B1366.endif ], [ %.1327, %B1746.endif.endif ]
  store ptr null, ptr %.1365, align 8
  %.1369 = call i32 @add_scaled.29(ptr nonnull %.1365, ptr nonnull %excinfo.10, i64 %.101, double 1.000000e+00, ptr %arg.y_bar, ptr %.1362)
  switch i32 %.1369, label %B1862.if [
    i32 -2, label %B1862.endif
    i32 0, label %B1862.endif
  ]

B2396:
  store ptr null, ptr %.1780, align 8
  %.1784 = call i32 @copy.27(ptr nonnull %.1780, ptr nonnull %excinfo.14, i64 %.101, ptr %.1528, ptr %.156)
  switch i32 %.1784, label %B2396.if [
    i32 -2, label %B2396.endif
    i32 0, label %B2396.endif
  ]

B2568:
  store ptr null, ptr %.1888, align 8
  %.1892 = call i32 @add_scaled.29(ptr nonnull %.1888, ptr nonnull %excinfo.17, i64 %.101, double 1.000000e+00, ptr %arg.y_bar, ptr %arg.Y_bar)
  switch i32 %.1892, label %B2568.if [
    i32 -2, label %B2604
    i32 0, label %B2604
  ]

B2604:
  store ptr null, ptr %.1917, align 8
  %.1921 = call i32 @add_scaled.29(ptr nonnull %.1917, ptr nonnull %excinfo.18, i64 %.101, double 1.000000e+00, ptr %arg.Y_bar, ptr %.181)
  switch i32 %.1921, label %B2604.if [
    i32 -2, label %B2604.endif
    i32 0, label %B2604.endif
  ]

B2800:
  %.2151 = icmp samesign ugt i64 %.1424.0930, 6
  br i1 %.2151, label %B3136, label %B2830.if.lr.ph

B2830.if.lr.ph:
  %.idx666 = shl nuw nsw i64 %35, 6
  %30 = getelementptr i8, ptr %arg.method, i64 %.idx666
  %31 = getelementptr i8, ptr %30, i64 512
  br label %B2830.if

B3136:
  %h_bar.8.2.lcssa = phi double [ %.1952, %B2800 ], [ %.2347, %B2832.endif.endif.endif ]
  %.2365 = getelementptr double, ptr %arg.work, i64 %.1526
  store double 0.000000e+00, ptr %.2368, align 8
  %.2372 = call i32 @dot.53(ptr nonnull %.2368, ptr nonnull %excinfo.22, i64 %.101, ptr %.160, ptr %.2365)
  switch i32 %.2372, label %B3136.if [
    i32 -2, label %B3136.endif
    i32 0, label %B3136.endif
  ]

B3364:
  br i1 %.2563934.not, label %B3410, label %B3394.if.preheader

B3394.if.preheader:
  call void @llvm.memset.p0.i64(ptr align 8 %scevgep, i8 0, i64 %17, i1 false)
  br label %B3410

B3410:
  br i1 %.2689942.not, label %B3606, label %B3440.if

B3582:
  %.2702 = add nuw nsw i64 %.2633.0943, 1
  %.2884 = getelementptr i32, ptr %arg.entry_places, i64 %.2633.0943
  %.2885 = load i32, ptr %.2884, align 4
  %.2890 = sext i32 %.2885 to i64
  %.2891 = getelementptr double, ptr %.217, i64 %.2890
  store double %.2874, ptr %.2891, align 8
  %exitcond1196.not = icmp eq i64 %arg.entry_count, %.2702
  br i1 %exitcond1196.not, label %B3606, label %B3440.if

B3606:
  %.2902 = load i64, ptr %.112, align 8
  %.2983945 = icmp sgt i64 %.2902, -1
  br i1 %.2983945, label %B3664.if.preheader, label %B3680

B3664.if.preheader:
  %storemerge660 = add nuw i64 %.2902, 1
  %32 = add nuw i64 %.2902, 2
  %smin1198 = call i64 @llvm.smin.i64(i64 %storemerge660, i64 1)
  %33 = sub i64 %32, %smin1198
  %34 = shl nuw i64 %33, 3
  call void @llvm.memset.p0.i64(ptr align 8 %scevgep1197, i8 0, i64 %34, i1 false)
  br label %B3680

B3680:
  br i1 %.3109948.not, label %B3890, label %B3710.if

B3890:
  store ptr null, ptr %.3203, align 8
  %.3207 = call i32 @copy.27(ptr nonnull %.3203, ptr nonnull %excinfo.25, i64 %.101, ptr %.398, ptr %arg.Y)
  switch i32 %.3207, label %B3890.if [
    i32 -2, label %B3890.endif
    i32 0, label %B3890.endif
  ]

B4030:
  store ptr null, ptr %.3408, align 8
  %.3412 = call i32 @pull_drive.54(ptr nonnull %.3408, ptr nonnull %excinfo.27, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, i64 1, ptr %.232, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %.241, ptr %.249)
  switch i32 %.3412, label %B4030.if [
    i32 -2, label %B4030.endif
    i32 0, label %B4030.endif
  ]

B4286:
  %.3576 = load double, ptr %.3575, align 8
  %.3578 = fadd contract double %.2432, %.3576
  store double %.3578, ptr %.3575, align 8
  br label %B4318

B4318:
  %.3586 = icmp eq i64 %.329.sroa.0.0961, %.381
  br i1 %.3586, label %B4336, label %B4374

B4336:
  %.3592 = load double, ptr %arg.ends_bar, align 8
  %.3595 = fsub contract double %.3509, %.2432
  %.3600 = fadd contract double %.3595, %.3592
  store double %.3600, ptr %arg.ends_bar, align 8
  br label %B4374

B4374:
  %.339 = icmp sgt i64 %.283.1960, 0
  %.352 = zext i1 %.339 to i64
  %.280.1 = add i64 %.280.1959, %.352
  %.348 = sext i1 %.339 to i64
  %.283.1 = add nsw i64 %.283.1960, %.348
  %.329.sroa.0.0 = select i1 %.339, i64 %.280.1959, i64 0
  br i1 %.339, label %B918, label %B4378

common.ret:
  %common.ret.op = phi i32 [ 0, %B4378 ], [ %.3551, %B4030.endif.endif.endif.endif.if ], [ %.3523, %B4030.endif.endif.endif.if ], [ %.3484, %B4030.endif.endif.if ], [ %.3448, %B4030.endif.if ], [ %.506, %B918.if ], [ %.3412, %B4030.if ], [ %.823, %B1366.if ], [ %.980, %B1434.if ], [ %.1017, %B1434.endif.if ], [ %.3249, %B3890.endif.if ], [ %.1046, %B1434.endif.endif.if ], [ %.1190, %B1638.if ], [ %.1221, %B1638.endif.if ], [ %.1258, %B1746.if ], [ %.1286, %B1746.endif.if ], [ %.2372, %B3136.if ], [ %.1369, %B1862.if ], [ %.1551, %B2034.if ], [ %.1583, %B2034.endif.if ], [ %.3207, %B3890.if ], [ %.1629, %B2034.endif.endif.if ], [ %.1784, %B2396.if ], [ %.1824, %B2396.endif.if ], [ %.1860, %B2396.endif.endif.if ], [ %.1892, %B2568.if ], [ %.2452, %B3136.endif.endif.if ], [ %.2411, %B3136.endif.if ], [ %.1921, %B2604.if ], [ %.2248, %B2832.if ], [ %.2282, %B2832.endif.if ], [ %.2320, %B2832.endif.endif.if ]
  ret i32 %common.ret.op

B4378:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B918.if:
  %.514 = icmp sgt i32 %.506, 0
  %.507 = load ptr, ptr %excinfo.1, align 8
  %.515 = select i1 %.514, ptr %.507, ptr undef
  store ptr %.515, ptr %excinfo, align 8
  br label %common.ret

B918.endif:
  br i1 %.624905, label %B1292.if.preheader, label %B1308

B1292.if.preheader:
  call void @llvm.memset.p0.i64(ptr align 8 %.144, i8 0, i64 %6, i1 false)
  br label %B1308

B1338.if:
  %.694.0909 = phi i64 [ %.763, %B1338.if ], [ 0, %B1308 ]
  %.763 = add nuw nsw i64 %.694.0909, 1
  %.793 = getelementptr double, ptr %.181, i64 %.694.0909
  store double 0.000000e+00, ptr %.793, align 8
  %.796 = getelementptr double, ptr %.177, i64 %.694.0909
  store double 0.000000e+00, ptr %.796, align 8
  %exitcond.not = icmp eq i64 %.101, %.763
  br i1 %exitcond.not, label %B1366, label %B1338.if

B1366.if:
  %.831 = icmp sgt i32 %.823, 0
  %.824 = load ptr, ptr %excinfo.2, align 8
  %.832 = select i1 %.831, ptr %.824, ptr undef
  store ptr %.832, ptr %excinfo, align 8
  br label %common.ret

B1366.endif:
  %.886 = sub i64 %stop.2.0958, %.833
  %.929913.not = icmp slt i64 %.886, 1
  br i1 %.929913.not, label %B1862, label %B1432.if

B1432.if:
  %time_bar.4.1917 = phi double [ %.1327, %B1746.endif.endif ], [ 0.000000e+00, %B1366.endif ]
  %h_bar.6.1916 = phi double [ %.1318, %B1746.endif.endif ], [ 0.000000e+00, %B1366.endif ]
  %.876.0915 = phi i64 [ %.938, %B1746.endif.endif ], [ %.886, %B1366.endif ]
  %.873.0914 = phi i64 [ %.942, %B1746.endif.endif ], [ %.833, %B1366.endif ]
  %.938 = add nsw i64 %.876.0915, -1
  %.942 = add i64 %.873.0914, 1
  %.968 = mul nsw i64 %.873.0914, %.101
  %.970 = getelementptr double, ptr %arg.weights, i64 %.968
  %.973 = getelementptr double, ptr %arg.edges, i64 %.873.0914
  %.974 = load double, ptr %.973, align 8
  store double 0.000000e+00, ptr %.976, align 8
  %.980 = call i32 @part_done.55(ptr nonnull %.976, ptr nonnull %excinfo.3, double %.974, ptr nonnull %.387)
  %.990 = load double, ptr %.976, align 8
  switch i32 %.980, label %B1434.if [
    i32 -2, label %B1434.endif
    i32 0, label %B1434.endif
  ]

B1434.if:
  %.988 = icmp sgt i32 %.980, 0
  %.981 = load ptr, ptr %excinfo.3, align 8
  %.989 = select i1 %.988, ptr %.981, ptr undef
  store ptr %.989, ptr %excinfo, align 8
  br label %common.ret

B1434.endif:
  %.1009 = fsub contract double 1.000000e+00, %.990
  store ptr null, ptr %.1013, align 8
  %.1017 = call i32 @add_scaled.29(ptr nonnull %.1013, ptr nonnull %excinfo.4, i64 %.101, double %.1009, ptr %.970, ptr %.181)
  switch i32 %.1017, label %B1434.endif.if [
    i32 -2, label %B1434.endif.endif
    i32 0, label %B1434.endif.endif
  ]

B1434.endif.if:
  %.1025 = icmp sgt i32 %.1017, 0
  %.1018 = load ptr, ptr %excinfo.4, align 8
  %.1026 = select i1 %.1025, ptr %.1018, ptr undef
  store ptr %.1026, ptr %excinfo, align 8
  br label %common.ret

B1434.endif.endif:
  store ptr null, ptr %.1042, align 8
  %.1046 = call i32 @add_scaled.29(ptr nonnull %.1042, ptr nonnull %excinfo.5, i64 %.101, double %.990, ptr %.970, ptr %arg.y_bar)
  switch i32 %.1046, label %B1434.endif.endif.if [
    i32 -2, label %B1636.if.preheader
    i32 0, label %B1636.if.preheader
  ]

B1636.if.preheader:
  br label %B1636.if

B1434.endif.endif.if:
  %.1054 = icmp sgt i32 %.1046, 0
  %.1047 = load ptr, ptr %excinfo.5, align 8
  %.1055 = select i1 %.1054, ptr %.1047, ptr undef
  store ptr %.1055, ptr %excinfo, align 8
  br label %common.ret

B1636.if:
  %.1089.0911 = phi i64 [ %.1158, %B1638.endif.endif ], [ 0, %B1636.if.preheader ]
  %.1158 = add nuw nsw i64 %.1089.0911, 1
  store double 0.000000e+00, ptr %.1186, align 8
  %.1190 = call i32 @dense_weight.56(ptr nonnull %.1186, ptr nonnull %excinfo.6, ptr %arg.method, i64 %.1089.0911, double %.990)
  switch i32 %.1190, label %B1638.if [
    i32 -2, label %B1638.endif
    i32 0, label %B1638.endif
  ]

B1638.if:
  %.1198 = icmp sgt i32 %.1190, 0
  %.1191 = load ptr, ptr %excinfo.6, align 8
  %.1199 = select i1 %.1198, ptr %.1191, ptr undef
  store ptr %.1199, ptr %excinfo, align 8
  br label %common.ret

B1638.endif:
  %.1200 = load double, ptr %.1186, align 8
  %.1212 = mul nsw i64 %.1089.0911, %.101
  %.1214 = getelementptr double, ptr %.144, i64 %.1212
  store ptr null, ptr %.1217, align 8
  %.1221 = call i32 @add_scaled.29(ptr nonnull %.1217, ptr nonnull %excinfo.7, i64 %.101, double %.1200, ptr %.970, ptr %.1214)
  switch i32 %.1221, label %B1638.endif.if [
    i32 -2, label %B1638.endif.endif
    i32 0, label %B1638.endif.endif
  ]

B1638.endif.if:
  %.1229 = icmp sgt i32 %.1221, 0
  %.1222 = load ptr, ptr %excinfo.7, align 8
  %.1230 = select i1 %.1229, ptr %.1222, ptr undef
  store ptr %.1230, ptr %excinfo, align 8
  br label %common.ret

B1638.endif.endif:
  %exitcond1191.not = icmp eq i64 %.1158, 8
  br i1 %exitcond1191.not, label %B1746, label %B1636.if

B1746.if:
  %.1266 = icmp sgt i32 %.1258, 0
  %.1259 = load ptr, ptr %excinfo.8, align 8
  %.1267 = select i1 %.1266, ptr %.1259, ptr undef
  store ptr %.1267, ptr %excinfo, align 8
  br label %common.ret

B1746.endif:
  store double 0.000000e+00, ptr %.1282, align 8
  %.1286 = call i32 @dot.53(ptr nonnull %.1282, ptr nonnull %excinfo.9, i64 %.101, ptr %.970, ptr %.156)
  switch i32 %.1286, label %B1746.endif.if [
    i32 -2, label %B1746.endif.endif
    i32 0, label %B1746.endif.endif
  ]

B1746.endif.if:
  %.1294 = icmp sgt i32 %.1286, 0
  %.1287 = load ptr, ptr %excinfo.9, align 8
  %.1295 = select i1 %.1294, ptr %.1287, ptr undef
  store ptr %.1295, ptr %excinfo, align 8
  br label %common.ret

B1746.endif.endif:
  %.1296 = load double, ptr %.1282, align 8
  %.1309 = fmul contract double %.990, %.1296
  %.1316 = fdiv contract double %.1309, %.396
  %.1318 = fsub contract double %h_bar.6.1916, %.1316
  %.1325 = fdiv contract double %.1296, %.396
  %.1327 = fsub contract double %time_bar.4.1917, %.1325
  %.929 = icmp sgt i64 %.876.0915, 1
  br i1 %.929, label %B1432.if, label %B1862

B1862.if:
  %.1377 = icmp sgt i32 %.1369, 0
  %.1370 = load ptr, ptr %excinfo.10, align 8
  %.1378 = select i1 %.1377, ptr %.1370, ptr undef
  store ptr %.1378, ptr %excinfo, align 8
  br label %common.ret

B1862.endif:
  %.1391 = load double, ptr %.1390, align 8
  %.1393 = fmul contract double %.396, %.1391
  %.1397 = fdiv contract double 1.000000e+00, %.1393
  br label %B2032.if

B2032.if:
  %time_bar.5.1933 = phi double [ %time_bar.4.1.lcssa, %B1862.endif ], [ %.1963, %B3136.endif.endif.endif ]
  %h_bar.7.1932 = phi double [ %h_bar.6.1.lcssa, %B1862.endif ], [ %.2432, %B3136.endif.endif.endif ]
  %.1424.0930 = phi i64 [ 0, %B1862.endif ], [ %.1494, %B3136.endif.endif.endif ]
  %.1494 = add nuw nsw i64 %.1424.0930, 1
  %35 = sub nuw nsw i64 7, %.1424.0930
  %.1526 = mul nsw i64 %35, %.101
  %.1528 = getelementptr double, ptr %.147, i64 %.1526
  %.1537 = getelementptr double, ptr %.144, i64 %.1526
  store ptr null, ptr %.1547, align 8
  %.1551 = call i32 @lu_solve_transposed.36(ptr nonnull %.1547, ptr nonnull %excinfo.11, i64 %.101, ptr %arg.slots, i64 %arg.blocks, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %.205, ptr %.1537, ptr %.1528, ptr %.198)
  switch i32 %.1551, label %B2034.if [
    i32 -2, label %B2034.endif
    i32 0, label %B2034.endif
  ]

B2034.if:
  %.1559 = icmp sgt i32 %.1551, 0
  %.1552 = load ptr, ptr %excinfo.11, align 8
  %.1560 = select i1 %.1559, ptr %.1552, ptr undef
  store ptr %.1560, ptr %excinfo, align 8
  br label %common.ret

B2034.endif:
  %.1576 = getelementptr double, ptr %.135, i64 %.1526
  store ptr null, ptr %.1579, align 8
  %.1583 = call i32 @copy.27(ptr nonnull %.1579, ptr nonnull %excinfo.12, i64 %.101, ptr %.1576, ptr %arg.Y)
  switch i32 %.1583, label %B2034.endif.if [
    i32 -2, label %B2034.endif.endif
    i32 0, label %B2034.endif.endif
  ]

B2034.endif.if:
  %.1591 = icmp sgt i32 %.1583, 0
  %.1584 = load ptr, ptr %excinfo.12, align 8
  %.1592 = select i1 %.1591, ptr %.1584, ptr undef
  store ptr %.1592, ptr %excinfo, align 8
  br label %common.ret

B2034.endif.endif:
  %36 = getelementptr double, ptr %arg.method, i64 %35
  %.1606 = getelementptr i8, ptr %36, i64 1024
  %.1607 = load double, ptr %.1606, align 8
  %.1609 = fmul contract double %.396, %.1607
  %.1611 = fadd contract double %.393, %.1609
  store double %.1611, ptr %.1614, align 8
  store ptr null, ptr %.1625, align 8
  %.1629 = call i32 @drive.6(ptr nonnull %.1625, ptr nonnull %excinfo.13, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.241, ptr %.249)
  switch i32 %.1629, label %B2034.endif.endif.if [
    i32 -2, label %B2034.endif.endif.endif
    i32 0, label %B2034.endif.endif.endif
  ]

B2034.endif.endif.if:
  %.1637 = icmp sgt i32 %.1629, 0
  %.1630 = load ptr, ptr %excinfo.13, align 8
  %.1638 = select i1 %.1637, ptr %.1630, ptr undef
  store ptr %.1638, ptr %excinfo, align 8
  br label %common.ret

B2034.endif.endif.endif:
  br i1 %.1730919, label %B2380.if.preheader, label %B2396

B2380.if.preheader:
  call void @llvm.memset.p0.i64(ptr align 8 %arg.Y_bar, i8 0, i64 %9, i1 false)
  br label %B2396

B2396.if:
  %.1792 = icmp sgt i32 %.1784, 0
  %.1785 = load ptr, ptr %excinfo.14, align 8
  %.1793 = select i1 %.1792, ptr %.1785, ptr undef
  store ptr %.1793, ptr %excinfo, align 8
  br label %common.ret

B2396.endif:
  store double 0.000000e+00, ptr %.1806, align 8
  store ptr null, ptr %.1820, align 8
  %.1824 = call i32 @pull_residual.41(ptr nonnull %.1820, ptr nonnull %excinfo.15, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.156, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %.241, ptr %.249)
  switch i32 %.1824, label %B2396.endif.if [
    i32 -2, label %B2396.endif.endif
    i32 0, label %B2396.endif.endif
  ]

B2396.endif.if:
  %.1832 = icmp sgt i32 %.1824, 0
  %.1825 = load ptr, ptr %excinfo.15, align 8
  %.1833 = select i1 %.1832, ptr %.1825, ptr undef
  store ptr %.1833, ptr %excinfo, align 8
  br label %common.ret

B2396.endif.endif:
  store ptr null, ptr %.1856, align 8
  %.1860 = call i32 @drives_bar.42(ptr nonnull %.1856, ptr nonnull %excinfo.16, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %.232, ptr %.241, ptr %.249)
  switch i32 %.1860, label %B2396.endif.endif.if [
    i32 -2, label %B2396.endif.endif.endif
    i32 0, label %B2396.endif.endif.endif
  ]

B2396.endif.endif.if:
  %.1868 = icmp sgt i32 %.1860, 0
  %.1861 = load ptr, ptr %excinfo.16, align 8
  %.1869 = select i1 %.1868, ptr %.1861, ptr undef
  store ptr %.1869, ptr %excinfo, align 8
  br label %common.ret

B2396.endif.endif.endif:
  %.1882 = icmp eq i64 %.1424.0930, 0
  br i1 %.1882, label %B2568, label %B2604

B2568.if:
  %.1900 = icmp sgt i32 %.1892, 0
  %.1893 = load ptr, ptr %excinfo.17, align 8
  %.1901 = select i1 %.1900, ptr %.1893, ptr undef
  store ptr %.1901, ptr %excinfo, align 8
  br label %common.ret

B2604.if:
  %.1929 = icmp sgt i32 %.1921, 0
  %.1922 = load ptr, ptr %excinfo.18, align 8
  %.1930 = select i1 %.1929, ptr %.1922, ptr undef
  store ptr %.1930, ptr %excinfo, align 8
  br label %common.ret

B2604.endif:
  %.1945 = load double, ptr %.1606, align 8
  %.1949 = load double, ptr %.1948, align 8
  %.1950 = fmul contract double %.1945, %.1949
  %.1952 = fadd contract double %h_bar.7.1932, %.1950
  %.1963 = fadd contract double %time_bar.5.1933, %.1949
  br i1 %.2049922.not, label %B2800, label %B2748.if

B2748.if:
  %.1993.0923 = phi i64 [ %.2062, %B2748.if ], [ 0, %B2604.endif ]
  %.2062 = add nuw nsw i64 %.1993.0923, 1
  %.2088 = getelementptr double, ptr %arg.mass, i64 %.1993.0923
  %.2089 = load double, ptr %.2088, align 8
  %.2091 = getelementptr double, ptr %.1528, i64 %.1993.0923
  %.2092 = load double, ptr %.2091, align 8
  %.2093 = fmul contract double %.2089, %.2092
  %.2098 = fdiv contract double %.2093, %.396
  %.2100 = getelementptr double, ptr %.160, i64 %.1993.0923
  store double %.2098, ptr %.2100, align 8
  %exitcond1192.not = icmp eq i64 %.101, %.2062
  br i1 %exitcond1192.not, label %B2800, label %B2748.if

B2830.if:
  %h_bar.8.2928 = phi double [ %.1952, %B2830.if.lr.ph ], [ %.2347, %B2832.endif.endif.endif ]
  %.2137.0926 = phi i64 [ 0, %B2830.if.lr.ph ], [ %.2206, %B2832.endif.endif.endif ]
  %.2206 = add nuw nsw i64 %.2137.0926, 1
  %.2232 = mul nsw i64 %.2137.0926, %.101
  %.2234 = getelementptr double, ptr %.144, i64 %.2232
  %.2240 = getelementptr double, ptr %30, i64 %.2137.0926
  %.2241 = load double, ptr %.2240, align 8
  store ptr null, ptr %.2244, align 8
  %.2248 = call i32 @add_scaled.29(ptr nonnull %.2244, ptr nonnull %excinfo.19, i64 %.101, double %.2241, ptr %arg.Y_bar, ptr %.2234)
  switch i32 %.2248, label %B2832.if [
    i32 -2, label %B2832.endif
    i32 0, label %B2832.endif
  ]

B2832.if:
  %.2256 = icmp sgt i32 %.2248, 0
  %.2249 = load ptr, ptr %excinfo.19, align 8
  %.2257 = select i1 %.2256, ptr %.2249, ptr undef
  store ptr %.2257, ptr %excinfo, align 8
  br label %common.ret

B2832.endif:
  %.2274 = getelementptr double, ptr %31, i64 %.2137.0926
  %.2275 = load double, ptr %.2274, align 8
  store ptr null, ptr %.2278, align 8
  %.2282 = call i32 @add_scaled.29(ptr nonnull %.2278, ptr nonnull %excinfo.20, i64 %.101, double %.2275, ptr %.160, ptr %.2234)
  switch i32 %.2282, label %B2832.endif.if [
    i32 -2, label %B2832.endif.endif
    i32 0, label %B2832.endif.endif
  ]

B2832.endif.if:
  %.2290 = icmp sgt i32 %.2282, 0
  %.2283 = load ptr, ptr %excinfo.20, align 8
  %.2291 = select i1 %.2290, ptr %.2283, ptr undef
  store ptr %.2291, ptr %excinfo, align 8
  br label %common.ret

B2832.endif.endif:
  %.2308 = load double, ptr %.2274, align 8
  %.2313 = getelementptr double, ptr %arg.work, i64 %.2232
  store double 0.000000e+00, ptr %.2316, align 8
  %.2320 = call i32 @dot.53(ptr nonnull %.2316, ptr nonnull %excinfo.21, i64 %.101, ptr %.160, ptr %.2313)
  switch i32 %.2320, label %B2832.endif.endif.if [
    i32 -2, label %B2832.endif.endif.endif
    i32 0, label %B2832.endif.endif.endif
  ]

B2832.endif.endif.if:
  %.2328 = icmp sgt i32 %.2320, 0
  %.2321 = load ptr, ptr %excinfo.21, align 8
  %.2329 = select i1 %.2328, ptr %.2321, ptr undef
  store ptr %.2329, ptr %excinfo, align 8
  br label %common.ret

B2832.endif.endif.endif:
  %.2330 = load double, ptr %.2316, align 8
  %.2340 = fmul contract double %.2308, %.2330
  %.2345 = fdiv contract double %.2340, %.396
  %.2347 = fsub contract double %h_bar.8.2928, %.2345
  %exitcond1193.not = icmp eq i64 %.2206, %35
  br i1 %exitcond1193.not, label %B3136, label %B2830.if

B3136.if:
  %.2380 = icmp sgt i32 %.2372, 0
  %.2373 = load ptr, ptr %excinfo.22, align 8
  %.2381 = select i1 %.2380, ptr %.2373, ptr undef
  store ptr %.2381, ptr %excinfo, align 8
  br label %common.ret

B3136.endif:
  %.2382 = load double, ptr %.2368, align 8
  %.2401 = getelementptr i8, ptr %36, i64 1088
  %.2402 = load double, ptr %.2401, align 8
  store double 0.000000e+00, ptr %.2407, align 8
  %.2411 = call i32 @dot.53(ptr nonnull %.2407, ptr nonnull %excinfo.23, i64 %.101, ptr %.1528, ptr %.164)
  switch i32 %.2411, label %B3136.endif.if [
    i32 -2, label %B3136.endif.endif
    i32 0, label %B3136.endif.endif
  ]

B3136.endif.if:
  %.2419 = icmp sgt i32 %.2411, 0
  %.2412 = load ptr, ptr %excinfo.23, align 8
  %.2420 = select i1 %.2419, ptr %.2412, ptr undef
  store ptr %.2420, ptr %excinfo, align 8
  br label %common.ret

B3136.endif.endif:
  %.2421 = load double, ptr %.2407, align 8
  %.2442 = load double, ptr %.2401, align 8
  %.2444 = fmul contract double %.396, %.2442
  store ptr null, ptr %.2448, align 8
  %.2452 = call i32 @add_scaled.29(ptr nonnull %.2448, ptr nonnull %excinfo.24, i64 %.101, double %.2444, ptr %.1528, ptr %.177)
  switch i32 %.2452, label %B3136.endif.endif.if [
    i32 -2, label %B3136.endif.endif.endif
    i32 0, label %B3136.endif.endif.endif
  ]

B3136.endif.endif.if:
  %.2460 = icmp sgt i32 %.2452, 0
  %.2453 = load ptr, ptr %excinfo.24, align 8
  %.2461 = select i1 %.2460, ptr %.2453, ptr undef
  store ptr %.2461, ptr %excinfo, align 8
  br label %common.ret

B3136.endif.endif.endif:
  %.2393 = fmul contract double %.1397, %.2382
  %.2395 = fadd contract double %h_bar.8.2.lcssa, %.2393
  %.2431 = fmul contract double %.2402, %.2421
  %.2432 = fadd contract double %.2395, %.2431
  %exitcond1194.not = icmp eq i64 %.1494, 8
  br i1 %exitcond1194.not, label %B3364, label %B2032.if

B3440.if:
  %.2633.0943 = phi i64 [ %.2702, %B3582 ], [ 0, %B3410 ]
  %.2854 = getelementptr i32, ptr %arg.entry_rows, i64 %.2633.0943
  %.2855 = load i32, ptr %.2854, align 4
  %.2856 = sext i32 %.2855 to i64
  %invariant.gep = getelementptr double, ptr %.147, i64 %.2856
  %.2865 = getelementptr i32, ptr %arg.entry_columns, i64 %.2633.0943
  %.2866 = load i32, ptr %.2865, align 4
  %.2867 = sext i32 %.2866 to i64
  %invariant.gep937 = getelementptr double, ptr %arg.work, i64 %.2867
  br label %B3488.if

B3488.if:
  %total.2.2941 = phi double [ 0.000000e+00, %B3440.if ], [ %.2874, %B3488.if ]
  %.2756.0939 = phi i64 [ 0, %B3440.if ], [ %.2825, %B3488.if ]
  %.2825 = add nuw nsw i64 %.2756.0939, 1
  %37 = mul nsw i64 %.2756.0939, %.101
  %gep = getelementptr double, ptr %invariant.gep, i64 %37
  %.2860 = load double, ptr %gep, align 8
  %gep938 = getelementptr double, ptr %invariant.gep937, i64 %37
  %.2871 = load double, ptr %gep938, align 8
  %.2872 = fmul contract double %.2860, %.2871
  %.2874 = fadd contract double %total.2.2941, %.2872
  %exitcond1195.not = icmp eq i64 %.2825, 8
  br i1 %exitcond1195.not, label %B3582, label %B3488.if

B3710.if:
  %.3053.0949 = phi i64 [ %.3122, %B3710.if ], [ 0, %B3680 ]
  %.3122 = add nuw nsw i64 %.3053.0949, 1
  %.3148 = getelementptr i32, ptr %arg.drive_rows, i64 %.3053.0949
  %.3149 = load i32, ptr %.3148, align 4
  %.3151 = sext i32 %.3149 to i64
  %.3152 = getelementptr double, ptr %.177, i64 %.3151
  %.3153 = load double, ptr %.3152, align 8
  %.3155 = getelementptr i32, ptr %arg.drive_columns, i64 %.3053.0949
  %.3156 = load i32, ptr %.3155, align 4
  %.3158 = sext i32 %.3156 to i64
  %.3159 = getelementptr double, ptr %.223, i64 %.3158
  %.3160 = load double, ptr %.3159, align 8
  %.3161 = fmul contract double %.3153, %.3160
  %.3164 = add nsw i64 %.3053.0949, %.126
  %.3166 = getelementptr double, ptr %.217, i64 %.3164
  store double %.3161, ptr %.3166, align 8
  %.3173 = getelementptr double, ptr %.232, i64 %.3158
  %.3174 = load double, ptr %.3173, align 8
  %.3181 = load double, ptr %.3152, align 8
  %.3186 = getelementptr double, ptr %.211, i64 %.3164
  %.3187 = load double, ptr %.3186, align 8
  %.3188 = fmul contract double %.3181, %.3187
  %.3189 = fadd contract double %.3174, %.3188
  store double %.3189, ptr %.3173, align 8
  %exitcond1199.not = icmp eq i64 %.118, %.3122
  br i1 %exitcond1199.not, label %B3890, label %B3710.if

B3890.if:
  %.3215 = icmp sgt i32 %.3207, 0
  %.3208 = load ptr, ptr %excinfo.25, align 8
  %.3216 = select i1 %.3215, ptr %.3208, ptr undef
  store ptr %.3216, ptr %excinfo, align 8
  br label %common.ret

B3890.endif:
  store double %.393, ptr %.3232, align 8
  store ptr null, ptr %.3245, align 8
  %.3249 = call i32 @drive.6(ptr nonnull %.3245, ptr nonnull %excinfo.26, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.241, ptr %.249)
  switch i32 %.3249, label %B3890.endif.if [
    i32 -2, label %B3890.endif.endif
    i32 0, label %B3890.endif.endif
  ]

B3890.endif.if:
  %.3257 = icmp sgt i32 %.3249, 0
  %.3250 = load ptr, ptr %excinfo.26, align 8
  %.3258 = select i1 %.3257, ptr %.3250, ptr undef
  store ptr %.3258, ptr %excinfo, align 8
  br label %common.ret

B3890.endif.endif:
  br i1 %.3350951, label %B4014.if.preheader, label %B4030

B4014.if.preheader:
  call void @llvm.memset.p0.i64(ptr align 8 %arg.Y_bar, i8 0, i64 %29, i1 false)
  br label %B4030

B4030.if:
  %.3420 = icmp sgt i32 %.3412, 0
  %.3413 = load ptr, ptr %excinfo.27, align 8
  %.3421 = select i1 %.3420, ptr %.3413, ptr undef
  store ptr %.3421, ptr %excinfo, align 8
  br label %common.ret

B4030.endif:
  store ptr null, ptr %.3444, align 8
  %.3448 = call i32 @pull_jacobian.57(ptr nonnull %.3444, ptr nonnull %excinfo.28, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.pos, ptr %arg.numbers, ptr %arg.Y, ptr %.217, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %.241, ptr %.249)
  switch i32 %.3448, label %B4030.endif.if [
    i32 -2, label %B4030.endif.endif
    i32 0, label %B4030.endif.endif
  ]

B4030.endif.if:
  %.3456 = icmp sgt i32 %.3448, 0
  %.3449 = load ptr, ptr %excinfo.28, align 8
  %.3457 = select i1 %.3456, ptr %.3449, ptr undef
  store ptr %.3457, ptr %excinfo, align 8
  br label %common.ret

B4030.endif.endif:
  store ptr null, ptr %.3480, align 8
  %.3484 = call i32 @drives_bar.42(ptr nonnull %.3480, ptr nonnull %excinfo.29, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %.232, ptr %.241, ptr %.249)
  switch i32 %.3484, label %B4030.endif.endif.if [
    i32 -2, label %B4030.endif.endif.endif
    i32 0, label %B4030.endif.endif.endif
  ]

B4030.endif.endif.if:
  %.3492 = icmp sgt i32 %.3484, 0
  %.3485 = load ptr, ptr %excinfo.29, align 8
  %.3493 = select i1 %.3492, ptr %.3485, ptr undef
  store ptr %.3493, ptr %excinfo, align 8
  br label %common.ret

B4030.endif.endif.endif:
  %.3507 = load double, ptr %.3506, align 8
  %.3509 = fadd contract double %.1963, %.3507
  store ptr null, ptr %.3519, align 8
  %.3523 = call i32 @copy.27(ptr nonnull %.3519, ptr nonnull %excinfo.30, i64 %.101, ptr %.181, ptr %arg.y_bar)
  switch i32 %.3523, label %B4030.endif.endif.endif.if [
    i32 -2, label %B4030.endif.endif.endif.endif
    i32 0, label %B4030.endif.endif.endif.endif
  ]

B4030.endif.endif.endif.if:
  %.3531 = icmp sgt i32 %.3523, 0
  %.3524 = load ptr, ptr %excinfo.30, align 8
  %.3532 = select i1 %.3531, ptr %.3524, ptr undef
  store ptr %.3532, ptr %excinfo, align 8
  br label %common.ret

B4030.endif.endif.endif.endif:
  store ptr null, ptr %.3547, align 8
  %.3551 = call i32 @add_scaled.29(ptr nonnull %.3547, ptr nonnull %excinfo.31, i64 %.101, double 1.000000e+00, ptr %arg.Y_bar, ptr %arg.y_bar)
  switch i32 %.3551, label %B4030.endif.endif.endif.endif.if [
    i32 -2, label %B4030.endif.endif.endif.endif.endif
    i32 0, label %B4030.endif.endif.endif.endif.endif
  ]

B4030.endif.endif.endif.endif.if:
  %.3559 = icmp sgt i32 %.3551, 0
  %.3552 = load ptr, ptr %excinfo.31, align 8
  %.3560 = select i1 %.3559, ptr %.3552, ptr undef
  store ptr %.3560, ptr %excinfo, align 8
  br label %common.ret

B4030.endif.endif.endif.endif.endif:
  %.3572 = icmp eq i64 %.329.sroa.0.0961, 0
  br i1 %.3572, label %B4286, label %B4318
}

define internal i32 @replay.50(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.pos, ptr noalias %arg.numbers, ptr noalias %arg.drive_rows, ptr noalias %arg.drive_columns, i64 %arg.blocks, ptr noalias %arg.own, ptr noalias %arg.slots, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.mass, ptr noalias %arg.method, ptr noalias %arg.step, i64 %arg.step_length, ptr noalias %arg.Y, ptr noalias %arg.stages, ptr noalias %arg.places, ptr noalias %arg.J, ptr noalias %arg.rates, ptr noalias %arg.drift, ptr noalias %arg.lu, ptr noalias %arg.right, ptr noalias %arg.after, ptr noalias %arg.row, ptr noalias %arg.x, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.116 = alloca ptr, align 8
  store ptr null, ptr %.116, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.159 = alloca ptr, align 8
  store ptr null, ptr %.159, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.189 = alloca i64, align 8
  store i64 0, ptr %.189, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.269 = alloca ptr, align 8
  store ptr null, ptr %.269, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.417 = alloca ptr, align 8
  store ptr null, ptr %.417, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.480 = alloca ptr, align 8
  store ptr null, ptr %.480, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.564 = alloca ptr, align 8
  store ptr null, ptr %.564, align 8
  %excinfo.7 = alloca ptr, align 8
  store ptr null, ptr %excinfo.7, align 8
  %.597 = alloca ptr, align 8
  store ptr null, ptr %.597, align 8
  %excinfo.8 = alloca ptr, align 8
  store ptr null, ptr %excinfo.8, align 8
  %.83 = load i64, ptr %arg.layout, align 8
  %.89 = load double, ptr %arg.step, align 8
  %.91 = getelementptr i8, ptr %arg.step, i64 8
  %.92 = load double, ptr %.91, align 8
  %.94 = getelementptr i8, ptr %arg.step, i64 24
  store ptr null, ptr %.116, align 8
  %.120 = call i32 @linearise.22(ptr nonnull %.116, ptr nonnull %excinfo.1, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.pos, ptr %arg.numbers, ptr %arg.drive_rows, ptr %arg.drive_columns, double %.89, ptr %.94, ptr %arg.Y, ptr %arg.J, ptr %arg.rates, ptr %arg.drift, ptr %arg.local, ptr %arg.out)
  switch i32 %.120, label %B0.if [
    i32 -2, label %B0.endif
    i32 0, label %B0.endif
  ]

B320:
  %.261 = shl nsw i64 %.83, 3
  %.265 = getelementptr double, ptr %arg.step, i64 %.214
  store ptr null, ptr %.269, align 8
  %.273 = call i32 @copy.27(ptr nonnull %.269, ptr nonnull %excinfo.4, i64 %.261, ptr %.265, ptr %arg.stages)
  switch i32 %.273, label %B320.if [
    i32 -2, label %B454.if.preheader
    i32 0, label %B454.if.preheader
  ]

B454.if.preheader:
  br label %B454.if

B504:
  store ptr null, ptr %.480, align 8
  %.484 = call i32 @solve_stages.58(ptr nonnull %.480, ptr nonnull %excinfo.6, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, i64 %arg.blocks, ptr %arg.slots, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %arg.mass, ptr %arg.method, double %.89, double %.92, ptr %.94, ptr %arg.Y, ptr %arg.drift, ptr %arg.lu, ptr %arg.stages, ptr %arg.places, i64 %.83, ptr %arg.right, ptr %arg.after, ptr %arg.x, ptr %arg.local, ptr %arg.out)
  switch i32 %.484, label %B504.if [
    i32 -2, label %B584
    i32 0, label %B584
  ]

B584:
  %.554.idx = shl i64 %.83, 6
  %.554 = getelementptr i8, ptr %arg.places, i64 %.554.idx
  %.558 = mul nsw i64 %.83, 7
  %.560 = getelementptr double, ptr %arg.places, i64 %.558
  store ptr null, ptr %.564, align 8
  %.568 = call i32 @copy.27(ptr nonnull %.564, ptr nonnull %excinfo.7, i64 %.83, ptr %.560, ptr %.554)
  switch i32 %.568, label %B584.if [
    i32 -2, label %B584.endif
    i32 0, label %B584.endif
  ]

B0.if:
  %.128 = icmp sgt i32 %.120, 0
  %.121 = load ptr, ptr %excinfo.1, align 8
  %.129 = select i1 %.128, ptr %.121, ptr undef
  store ptr %.129, ptr %excinfo, align 8
  br label %common.ret

B0.endif:
  %.145 = getelementptr i32, ptr %arg.lu_start, i64 %arg.blocks
  %.146 = load i32, ptr %.145, align 4
  %.148 = getelementptr i8, ptr %arg.method, i64 1344
  %.149 = load double, ptr %.148, align 8
  %.151 = fmul contract double %.92, %.149
  %.155 = fdiv contract double 1.000000e+00, %.151
  store ptr null, ptr %.159, align 8
  %.163 = call i32 @lu_fill.23(ptr nonnull %.159, ptr nonnull %excinfo.2, i64 %.83, i32 %.146, ptr %arg.J, ptr %arg.own, ptr %arg.mass, double %.155, ptr %arg.lu)
  switch i32 %.163, label %B0.endif.endif.if [
    i32 -2, label %B0.endif.endif.endif
    i32 0, label %B0.endif.endif.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ %.568, %B584.if ], [ %.120, %B0.if ], [ %.163, %B0.endif.endif.if ], [ %.193, %B0.endif.endif.endif.if ], [ %.601, %B584.endif.if ], [ %.273, %B320.if ], [ %.421, %B456.if ], [ %.484, %B504.if ], [ 0, %B584.endif.endif ]
  ret i32 %common.ret.op

B0.endif.endif.if:
  %.171 = icmp sgt i32 %.163, 0
  %.164 = load ptr, ptr %excinfo.2, align 8
  %.172 = select i1 %.171, ptr %.164, ptr undef
  store ptr %.172, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif:
  store i64 0, ptr %.189, align 8
  %.193 = call i32 @lu_factor.17(ptr nonnull %.189, ptr nonnull %excinfo.3, i64 %arg.blocks, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %arg.lu, ptr %arg.row)
  switch i32 %.193, label %B0.endif.endif.endif.if [
    i32 -2, label %B0.endif.endif.endif.endif
    i32 0, label %B0.endif.endif.endif.endif
  ]

B0.endif.endif.endif.if:
  %.201 = icmp sgt i32 %.193, 0
  %.194 = load ptr, ptr %excinfo.3, align 8
  %.202 = select i1 %.201, ptr %.194, ptr undef
  store ptr %.202, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endif:
  %.214 = add nsw i64 %.83, 3
  %.215 = icmp sgt i64 %arg.step_length, %.214
  br i1 %.215, label %B320, label %B504

B320.if:
  %.281 = icmp sgt i32 %.273, 0
  %.274 = load ptr, ptr %excinfo.4, align 8
  %.282 = select i1 %.281, ptr %.274, ptr undef
  store ptr %.282, ptr %excinfo, align 8
  br label %common.ret

B454.if:
  %.316.059 = phi i64 [ %.385, %B456.endif ], [ 0, %B454.if.preheader ]
  store ptr null, ptr %.417, align 8
  %.421 = call i32 @set_place.59(ptr nonnull %.417, ptr nonnull %excinfo.5, i64 %.83, i64 %.316.059, ptr %arg.method, ptr %.94, ptr %arg.stages, ptr %arg.places, i64 %.83)
  switch i32 %.421, label %B456.if [
    i32 -2, label %B456.endif
    i32 0, label %B456.endif
  ]

B456.if:
  %.429 = icmp sgt i32 %.421, 0
  %.422 = load ptr, ptr %excinfo.5, align 8
  %.430 = select i1 %.429, ptr %.422, ptr undef
  store ptr %.430, ptr %excinfo, align 8
  br label %common.ret

B456.endif:
  %.385 = add nuw nsw i64 %.316.059, 1
  %exitcond.not = icmp eq i64 %.385, 8
  br i1 %exitcond.not, label %B584, label %B454.if

B504.if:
  %.492 = icmp sgt i32 %.484, 0
  %.485 = load ptr, ptr %excinfo.6, align 8
  %.493 = select i1 %.492, ptr %.485, ptr undef
  store ptr %.493, ptr %excinfo, align 8
  br label %common.ret

B584.if:
  %.576 = icmp sgt i32 %.568, 0
  %.569 = load ptr, ptr %excinfo.7, align 8
  %.577 = select i1 %.576, ptr %.569, ptr undef
  store ptr %.577, ptr %excinfo, align 8
  br label %common.ret

B584.endif:
  %.593 = getelementptr double, ptr %arg.stages, i64 %.558
  store ptr null, ptr %.597, align 8
  %.601 = call i32 @add_scaled.29(ptr nonnull %.597, ptr nonnull %excinfo.8, i64 %.83, double 1.000000e+00, ptr %.593, ptr %.554)
  switch i32 %.601, label %B584.endif.if [
    i32 -2, label %B584.endif.endif
    i32 0, label %B584.endif.endif
  ]

B584.endif.if:
  %.609 = icmp sgt i32 %.601, 0
  %.602 = load ptr, ptr %excinfo.8, align 8
  %.610 = select i1 %.609, ptr %.602, ptr undef
  store ptr %.610, ptr %excinfo, align 8
  br label %common.ret

B584.endif.endif:
  store ptr null, ptr %retptr, align 8
  br label %common.ret
}

define internal i32 @first_edge_in.51(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.edges, i64 %arg.stop, double %arg.time) noinline {
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

define internal i32 @part_done.55(ptr noalias %retptr, ptr noalias %excinfo, double %arg.edge, ptr noalias %arg.step) noinline {
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

define internal i32 @dense_weight.56(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.method, i64 %arg.j, double %arg.theta) noinline {
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

define internal i32 @dense_rate.52(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.method, double %arg.theta, ptr noalias %arg.y, ptr noalias %arg.end, ptr noalias %arg.stages, ptr noalias %arg.rate) noinline {
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

define internal i32 @dot.53(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y) noinline {
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

define internal i32 @pull_drive.54(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, i64 %arg.which, ptr noalias %arg.weights, ptr noalias %arg.Y_bar, ptr noalias %arg.numbers_bar, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
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
  %.194 = call i32 @pull.60(ptr nonnull %.190, ptr nonnull %excinfo.1, ptr %arg.layout, i64 %.167, i64 %arg.which, i64 %.172, ptr %.178, ptr %arg.derived, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.weights, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %arg.local, ptr %arg.out)
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

define internal i32 @pull_jacobian.57(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.pos, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.weights, ptr noalias %arg.Y_bar, ptr noalias %arg.numbers_bar, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
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
  %.367 = call i32 @pull.60(ptr nonnull %.363, ptr nonnull %excinfo.1, ptr %arg.layout, i64 %1, i64 1, i64 %.350, ptr %.170, ptr %arg.derived, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.weights, ptr %arg.Y_bar, ptr %arg.numbers_bar, ptr %arg.local, ptr %arg.out)
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

define internal i32 @pull.60(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, i64 %arg.table, i64 %arg.which, i64 %arg.results, ptr noalias %arg.places, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.weights, ptr noalias %arg.Y_bar, ptr noalias %arg.numbers_bar, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
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

define internal i32 @set_place.59(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, i64 %arg.i, ptr noalias %arg.method, ptr noalias %arg.y, ptr noalias %arg.stages, ptr noalias %arg.place_, i64 %arg.stride) noinline {
entry:
  %.44 = alloca ptr, align 8
  store ptr null, ptr %.44, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.203 = alloca ptr, align 8
  store ptr null, ptr %.203, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.264 = alloca ptr, align 8
  store ptr null, ptr %.264, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.306 = alloca ptr, align 8
  store ptr null, ptr %.306, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.27 = mul nsw i64 %arg.stride, %arg.i
  %.29 = getelementptr double, ptr %arg.place_, i64 %.27
  %.34 = icmp slt i64 %arg.i, 6
  br i1 %.34, label %B64, label %B232

B64:
  store ptr null, ptr %.44, align 8
  %.48 = call i32 @copy.27(ptr nonnull %.44, ptr nonnull %excinfo.1, i64 %arg.n, ptr %arg.y, ptr %.29)
  switch i32 %.48, label %B64.if [
    i32 -2, label %B64.endif
    i32 0, label %B64.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ 0, %B228 ], [ %.268, %B244.if ], [ %.310, %B318.if ], [ %.48, %B64.if ], [ %.207, %B130.if ], [ 0, %B318.endif ]
  ret i32 %common.ret.op

B228:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B232:
  %.249.not = icmp eq i64 %arg.stride, 0
  br i1 %.249.not, label %B318, label %B244

B244:
  %.253 = add nsw i64 %arg.i, -1
  %.255 = mul nsw i64 %arg.stride, %.253
  %.259 = getelementptr double, ptr %arg.place_, i64 %.255
  store ptr null, ptr %.264, align 8
  %.268 = call i32 @copy.27(ptr nonnull %.264, ptr nonnull %excinfo.3, i64 %arg.n, ptr %.259, ptr %.29)
  switch i32 %.268, label %B244.if [
    i32 -2, label %B318
    i32 0, label %B318
  ]

B318:
  %.295 = add nsw i64 %arg.i, -1
  %.299 = mul nsw i64 %.295, %arg.n
  %.301 = getelementptr double, ptr %arg.stages, i64 %.299
  store ptr null, ptr %.306, align 8
  %.310 = call i32 @add_scaled.29(ptr nonnull %.306, ptr nonnull %excinfo.4, i64 %arg.n, double 1.000000e+00, ptr %.301, ptr %.29)
  switch i32 %.310, label %B318.if [
    i32 -2, label %B318.endif
    i32 0, label %B318.endif
  ]

B64.if:
  %.56 = icmp sgt i32 %.48, 0
  %.49 = load ptr, ptr %excinfo.1, align 8
  %.57 = select i1 %.56, ptr %.49, ptr undef
  store ptr %.57, ptr %excinfo, align 8
  br label %common.ret

B64.endif:
  %.15257.not = icmp slt i64 %arg.i, 1
  br i1 %.15257.not, label %B228, label %B128.if.lr.ph

B128.if.lr.ph:
  %.idx = shl nuw nsw i64 %arg.i, 6
  %0 = getelementptr i8, ptr %arg.method, i64 %.idx
  br label %B128.if

B128.if:
  %.96.058 = phi i64 [ 0, %B128.if.lr.ph ], [ %.165, %B130.endif ]
  %.195 = getelementptr double, ptr %0, i64 %.96.058
  %.196 = load double, ptr %.195, align 8
  %.198 = mul nsw i64 %.96.058, %arg.n
  %.200 = getelementptr double, ptr %arg.stages, i64 %.198
  store ptr null, ptr %.203, align 8
  %.207 = call i32 @add_scaled.29(ptr nonnull %.203, ptr nonnull %excinfo.2, i64 %arg.n, double %.196, ptr %.200, ptr %.29)
  switch i32 %.207, label %B130.if [
    i32 -2, label %B130.endif
    i32 0, label %B130.endif
  ]

B130.if:
  %.215 = icmp sgt i32 %.207, 0
  %.208 = load ptr, ptr %excinfo.2, align 8
  %.216 = select i1 %.215, ptr %.208, ptr undef
  store ptr %.216, ptr %excinfo, align 8
  br label %common.ret

B130.endif:
  %.165 = add nuw nsw i64 %.96.058, 1
  %exitcond.not = icmp eq i64 %.165, %arg.i
  br i1 %exitcond.not, label %B228, label %B128.if

B244.if:
  %.276 = icmp sgt i32 %.268, 0
  %.269 = load ptr, ptr %excinfo.3, align 8
  %.277 = select i1 %.276, ptr %.269, ptr undef
  store ptr %.277, ptr %excinfo, align 8
  br label %common.ret

B318.if:
  %.318 = icmp sgt i32 %.310, 0
  %.311 = load ptr, ptr %excinfo.4, align 8
  %.319 = select i1 %.318, ptr %.311, ptr undef
  store ptr %.319, ptr %excinfo, align 8
  br label %common.ret

B318.endif:
  store ptr null, ptr %retptr, align 8
  br label %common.ret
}

define internal i32 @solve_stages.58(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, i64 %arg.blocks, ptr noalias %arg.slots, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.mass, ptr noalias %arg.method, double %arg.time, double %arg.h, ptr noalias %arg.y, ptr noalias %arg.Y, ptr noalias %arg.drift, ptr noalias %arg.lu, ptr noalias %arg.stages, ptr noalias %arg.place_, i64 %arg.stride, ptr noalias %arg.right, ptr noalias %arg.after, ptr noalias %arg.x, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.219 = alloca ptr, align 8
  store ptr null, ptr %.219, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.251 = alloca ptr, align 8
  store ptr null, ptr %.251, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.301 = alloca ptr, align 8
  store ptr null, ptr %.301, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.335 = alloca ptr, align 8
  store ptr null, ptr %.335, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.372 = alloca ptr, align 8
  store ptr null, ptr %.372, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.414 = alloca ptr, align 8
  store ptr null, ptr %.414, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.460 = alloca ptr, align 8
  store ptr null, ptr %.460, align 8
  %excinfo.7 = alloca ptr, align 8
  store ptr null, ptr %excinfo.7, align 8
  %.84 = load i64, ptr %arg.layout, align 8
  %.285 = getelementptr i8, ptr %arg.layout, i64 8
  %0 = getelementptr double, ptr %arg.Y, i64 %.84
  br label %B72.if

B498:
  store ptr null, ptr %.414, align 8
  %.418 = call i32 @add_scaled.29(ptr nonnull %.414, ptr nonnull %excinfo.6, i64 %.84, double %.402, ptr %arg.drift, ptr %arg.right)
  switch i32 %.418, label %B498.if [
    i32 -2, label %B534
    i32 0, label %B534
  ]

B534:
  %.445 = mul nsw i64 %.111.080, %.84
  %.449 = getelementptr double, ptr %arg.stages, i64 %.445
  store ptr null, ptr %.460, align 8
  %.464 = call i32 @lu_solve.19(ptr nonnull %.460, ptr nonnull %excinfo.7, i64 %.84, ptr %arg.slots, i64 %arg.blocks, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %arg.lu, ptr %arg.right, ptr %.449, ptr %arg.x)
  switch i32 %.464, label %B534.if [
    i32 -2, label %B534.endif
    i32 0, label %B534.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ 0, %B624 ], [ %.464, %B534.if ], [ %.418, %B498.if ], [ %.223, %B74.if ], [ %.255, %B74.endif.if ], [ %.305, %B74.endif.endif.if ], [ %.339, %B74.endif.endif.endif.if ], [ %.376, %B74.endif.endif.endif.endif.if ]
  ret i32 %common.ret.op

B624:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B72.if:
  %.111.080 = phi i64 [ 0, %entry ], [ %.183, %B534.endif ]
  %.183 = add nuw nsw i64 %.111.080, 1
  store ptr null, ptr %.219, align 8
  %.223 = call i32 @set_place.59(ptr nonnull %.219, ptr nonnull %excinfo.1, i64 %.84, i64 %.111.080, ptr %arg.method, ptr %arg.y, ptr %arg.stages, ptr %arg.place_, i64 %arg.stride)
  switch i32 %.223, label %B74.if [
    i32 -2, label %B74.endif
    i32 0, label %B74.endif
  ]

B74.if:
  %.231 = icmp sgt i32 %.223, 0
  %.224 = load ptr, ptr %excinfo.1, align 8
  %.232 = select i1 %.231, ptr %.224, ptr undef
  store ptr %.232, ptr %excinfo, align 8
  br label %common.ret

B74.endif:
  %.246 = mul nsw i64 %.111.080, %arg.stride
  %.248 = getelementptr double, ptr %arg.place_, i64 %.246
  store ptr null, ptr %.251, align 8
  %.255 = call i32 @copy.27(ptr nonnull %.251, ptr nonnull %excinfo.2, i64 %.84, ptr %.248, ptr %arg.Y)
  switch i32 %.255, label %B74.endif.if [
    i32 -2, label %B74.endif.endif
    i32 0, label %B74.endif.endif
  ]

B74.endif.if:
  %.263 = icmp sgt i32 %.255, 0
  %.256 = load ptr, ptr %excinfo.2, align 8
  %.264 = select i1 %.263, ptr %.256, ptr undef
  store ptr %.264, ptr %excinfo, align 8
  br label %common.ret

B74.endif.endif:
  %1 = getelementptr double, ptr %arg.method, i64 %.111.080
  %.278 = getelementptr i8, ptr %1, i64 1024
  %.279 = load double, ptr %.278, align 8
  %.281 = fmul contract double %arg.h, %.279
  %.283 = fadd contract double %arg.time, %.281
  %.286 = load i64, ptr %.285, align 8
  %.290 = getelementptr double, ptr %0, i64 %.286
  store double %.283, ptr %.290, align 8
  store ptr null, ptr %.301, align 8
  %.305 = call i32 @drive.6(ptr nonnull %.301, ptr nonnull %excinfo.3, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.local, ptr %arg.out)
  switch i32 %.305, label %B74.endif.endif.if [
    i32 -2, label %B74.endif.endif.endif
    i32 0, label %B74.endif.endif.endif
  ]

B74.endif.endif.if:
  %.313 = icmp sgt i32 %.305, 0
  %.306 = load ptr, ptr %excinfo.3, align 8
  %.314 = select i1 %.313, ptr %.306, ptr undef
  store ptr %.314, ptr %excinfo, align 8
  br label %common.ret

B74.endif.endif.endif:
  store ptr null, ptr %.335, align 8
  %.339 = call i32 @residual.0(ptr nonnull %.335, ptr nonnull %excinfo.4, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %arg.right, ptr %arg.local, ptr %arg.out)
  switch i32 %.339, label %B74.endif.endif.endif.if [
    i32 -2, label %B74.endif.endif.endif.endif
    i32 0, label %B74.endif.endif.endif.endif
  ]

B74.endif.endif.endif.if:
  %.347 = icmp sgt i32 %.339, 0
  %.340 = load ptr, ptr %excinfo.4, align 8
  %.348 = select i1 %.347, ptr %.340, ptr undef
  store ptr %.348, ptr %excinfo, align 8
  br label %common.ret

B74.endif.endif.endif.endif:
  %.idx = shl i64 %.111.080, 6
  %2 = getelementptr i8, ptr %arg.method, i64 %.idx
  %.364 = getelementptr i8, ptr %2, i64 512
  store ptr null, ptr %.372, align 8
  %.376 = call i32 @combine.32(ptr nonnull %.372, ptr nonnull %excinfo.5, i64 %.84, i64 %.111.080, ptr %.364, double %arg.h, ptr %arg.mass, ptr %arg.stages, ptr %arg.right, ptr %arg.after)
  switch i32 %.376, label %B74.endif.endif.endif.endif.if [
    i32 -2, label %B74.endif.endif.endif.endif.endif
    i32 0, label %B74.endif.endif.endif.endif.endif
  ]

B74.endif.endif.endif.endif.if:
  %.384 = icmp sgt i32 %.376, 0
  %.377 = load ptr, ptr %excinfo.5, align 8
  %.385 = select i1 %.384, ptr %.377, ptr undef
  store ptr %.385, ptr %excinfo, align 8
  br label %common.ret

B74.endif.endif.endif.endif.endif:
  %.399 = getelementptr i8, ptr %1, i64 1088
  %.400 = load double, ptr %.399, align 8
  %.402 = fmul contract double %arg.h, %.400
  %.407 = fcmp contract une double %.402, 0.000000e+00
  br i1 %.407, label %B498, label %B534

B498.if:
  %.426 = icmp sgt i32 %.418, 0
  %.419 = load ptr, ptr %excinfo.6, align 8
  %.427 = select i1 %.426, ptr %.419, ptr undef
  store ptr %.427, ptr %excinfo, align 8
  br label %common.ret

B534.if:
  %.472 = icmp sgt i32 %.464, 0
  %.465 = load ptr, ptr %excinfo.7, align 8
  %.473 = select i1 %.472, ptr %.465, ptr undef
  store ptr %.473, ptr %excinfo, align 8
  br label %common.ret

B534.endif:
  %exitcond.not = icmp eq i64 %.183, 8
  br i1 %exitcond.not, label %B624, label %B72.if
}

define i64 @forward(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, i64 %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, ptr %a14, i64 %a15, ptr %a16, ptr %a17, ptr %a18, ptr %a19, ptr %a20, ptr %a21, i64 %a22, i64 %a23, ptr %a24, i64 %a25, i64 %a26, ptr %a27, ptr %a28, ptr %a29, i64 %a30, ptr %a31, i64 %a32, ptr %a33, ptr %a34, ptr %a35) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @forward.61(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, i64 %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, ptr %a14, i64 %a15, ptr %a16, ptr %a17, ptr %a18, ptr %a19, ptr %a20, ptr %a21, i64 %a22, i64 %a23, ptr %a24, i64 %a25, i64 %a26, ptr %a27, ptr %a28, ptr %a29, i64 %a30, ptr %a31, i64 %a32, ptr %a33, ptr %a34, ptr %a35)
  ret i64 0
}

define internal i32 @forward.61(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.pos, ptr noalias %arg.numbers, ptr noalias %arg.drive_rows, ptr noalias %arg.drive_columns, i64 %arg.blocks, ptr noalias %arg.own, ptr noalias %arg.slots, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, i64 %arg.entry_count, ptr noalias %arg.entry_rows, ptr noalias %arg.entry_columns, ptr noalias %arg.entry_places, ptr noalias %arg.mass, ptr noalias %arg.method, ptr noalias %arg.record, i64 %arg.step_count, i64 %arg.step_length, ptr noalias %arg.edges, i64 %arg.edge_count, i64 %arg.directions, ptr noalias %arg.Y, ptr noalias %arg.y_dot, ptr noalias %arg.Y_dot, i64 %arg.Y_length, ptr noalias %arg.numbers_dot, i64 %arg.numbers_length, ptr noalias %arg.ends_dot, ptr noalias %arg.outputs, ptr noalias %arg.work) noinline {
entry:
  %.243 = alloca i64, align 8
  store i64 0, ptr %.243, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.447 = alloca i64, align 8
  store i64 0, ptr %.447, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.475 = alloca ptr, align 8
  store ptr null, ptr %.475, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.748 = alloca ptr, align 8
  store ptr null, ptr %.748, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.788 = alloca ptr, align 8
  store ptr null, ptr %.788, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.826 = alloca ptr, align 8
  store ptr null, ptr %.826, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.1253 = alloca double, align 8
  store double 0.000000e+00, ptr %.1253, align 8
  %excinfo.7 = alloca ptr, align 8
  store ptr null, ptr %excinfo.7, align 8
  %.1295 = alloca ptr, align 8
  store ptr null, ptr %.1295, align 8
  %excinfo.8 = alloca ptr, align 8
  store ptr null, ptr %excinfo.8, align 8
  %.1331 = alloca ptr, align 8
  store ptr null, ptr %.1331, align 8
  %excinfo.9 = alloca ptr, align 8
  store ptr null, ptr %excinfo.9, align 8
  %.1367 = alloca ptr, align 8
  store ptr null, ptr %.1367, align 8
  %excinfo.10 = alloca ptr, align 8
  store ptr null, ptr %excinfo.10, align 8
  %.1849 = alloca ptr, align 8
  store ptr null, ptr %.1849, align 8
  %excinfo.11 = alloca ptr, align 8
  store ptr null, ptr %excinfo.11, align 8
  %.1895 = alloca ptr, align 8
  store ptr null, ptr %.1895, align 8
  %excinfo.12 = alloca ptr, align 8
  store ptr null, ptr %excinfo.12, align 8
  %.1932 = alloca ptr, align 8
  store ptr null, ptr %.1932, align 8
  %excinfo.13 = alloca ptr, align 8
  store ptr null, ptr %excinfo.13, align 8
  %.2221 = alloca ptr, align 8
  store ptr null, ptr %.2221, align 8
  %excinfo.14 = alloca ptr, align 8
  store ptr null, ptr %excinfo.14, align 8
  %.2255 = alloca ptr, align 8
  store ptr null, ptr %.2255, align 8
  %excinfo.15 = alloca ptr, align 8
  store ptr null, ptr %excinfo.15, align 8
  %.2284 = alloca ptr, align 8
  store ptr null, ptr %.2284, align 8
  %excinfo.16 = alloca ptr, align 8
  store ptr null, ptr %excinfo.16, align 8
  %.2575 = alloca ptr, align 8
  store ptr null, ptr %.2575, align 8
  %excinfo.17 = alloca ptr, align 8
  store ptr null, ptr %excinfo.17, align 8
  %.2615 = alloca ptr, align 8
  store ptr null, ptr %.2615, align 8
  %excinfo.18 = alloca ptr, align 8
  store ptr null, ptr %excinfo.18, align 8
  %.2789 = alloca double, align 8
  store double 0.000000e+00, ptr %.2789, align 8
  %excinfo.19 = alloca ptr, align 8
  store ptr null, ptr %excinfo.19, align 8
  %.2818 = alloca double, align 8
  store double 0.000000e+00, ptr %.2818, align 8
  %excinfo.20 = alloca ptr, align 8
  store ptr null, ptr %excinfo.20, align 8
  %.2868 = alloca ptr, align 8
  store ptr null, ptr %.2868, align 8
  %excinfo.21 = alloca ptr, align 8
  store ptr null, ptr %excinfo.21, align 8
  %.3033 = alloca i64, align 8
  store i64 0, ptr %.3033, align 8
  %excinfo.22 = alloca ptr, align 8
  store ptr null, ptr %excinfo.22, align 8
  %.3073 = alloca ptr, align 8
  store ptr null, ptr %.3073, align 8
  %excinfo.23 = alloca ptr, align 8
  store ptr null, ptr %excinfo.23, align 8
  %.3276 = alloca ptr, align 8
  store ptr null, ptr %.3276, align 8
  %excinfo.24 = alloca ptr, align 8
  store ptr null, ptr %excinfo.24, align 8
  %.3441 = alloca ptr, align 8
  store ptr null, ptr %.3441, align 8
  %excinfo.25 = alloca ptr, align 8
  store ptr null, ptr %excinfo.25, align 8
  %.3488 = alloca ptr, align 8
  store ptr null, ptr %.3488, align 8
  %excinfo.26 = alloca ptr, align 8
  store ptr null, ptr %excinfo.26, align 8
  %.3608 = alloca ptr, align 8
  store ptr null, ptr %.3608, align 8
  %excinfo.27 = alloca ptr, align 8
  store ptr null, ptr %excinfo.27, align 8
  %.3763 = alloca double, align 8
  store double 0.000000e+00, ptr %.3763, align 8
  %excinfo.28 = alloca ptr, align 8
  store ptr null, ptr %excinfo.28, align 8
  %.3801 = alloca ptr, align 8
  store ptr null, ptr %.3801, align 8
  %excinfo.29 = alloca ptr, align 8
  store ptr null, ptr %excinfo.29, align 8
  %.4085 = alloca double, align 8
  store double 0.000000e+00, ptr %.4085, align 8
  %excinfo.30 = alloca ptr, align 8
  store ptr null, ptr %excinfo.30, align 8
  %.4118 = alloca ptr, align 8
  store ptr null, ptr %.4118, align 8
  %excinfo.31 = alloca ptr, align 8
  store ptr null, ptr %excinfo.31, align 8
  %.4274 = alloca double, align 8
  store double 0.000000e+00, ptr %.4274, align 8
  %excinfo.32 = alloca ptr, align 8
  store ptr null, ptr %excinfo.32, align 8
  %.4301 = alloca double, align 8
  store double 0.000000e+00, ptr %.4301, align 8
  %excinfo.33 = alloca ptr, align 8
  store ptr null, ptr %excinfo.33, align 8
  %.4520 = alloca ptr, align 8
  store ptr null, ptr %.4520, align 8
  %excinfo.34 = alloca ptr, align 8
  store ptr null, ptr %excinfo.34, align 8
  %.112 = load i64, ptr %arg.layout, align 8
  %.114 = getelementptr i8, ptr %arg.layout, i64 16
  %.115 = load i64, ptr %.114, align 8
  %.123 = getelementptr i8, ptr %arg.layout, i64 8
  %.124 = load i64, ptr %.123, align 8
  %.126 = add nsw i64 %.124, %.112
  %.128 = getelementptr i8, ptr %arg.layout, i64 24
  %.129 = load i64, ptr %.128, align 8
  %.137 = add nsw i64 %.115, 1
  %.139 = add nsw i64 %.129, %.137
  %.142 = shl nsw i64 %.112, 3
  %.143 = getelementptr double, ptr %arg.work, i64 %.142
  %.152.idx = mul i64 %.112, 136
  %.152 = getelementptr i8, ptr %arg.work, i64 %.152.idx
  %.idx = mul i64 %.112, 144
  %0 = getelementptr i8, ptr %arg.work, i64 %.idx
  %.156 = getelementptr i8, ptr %0, i64 8
  %.idx904 = mul i64 %.112, 152
  %1 = getelementptr i8, ptr %arg.work, i64 %.idx904
  %.160 = getelementptr i8, ptr %1, i64 8
  %.idx905 = mul i64 %.112, 160
  %2 = getelementptr i8, ptr %arg.work, i64 %.idx905
  %.173 = getelementptr i8, ptr %2, i64 8
  %.180.idx = shl i64 %arg.blocks, 5
  %.180 = getelementptr i8, ptr %.173, i64 %.180.idx
  %.187.idx = shl i64 %arg.blocks, 4
  %.187 = getelementptr i8, ptr %.180, i64 %.187.idx
  %.193 = getelementptr double, ptr %.187, i64 %.115
  %.198 = getelementptr double, ptr %.193, i64 %.139
  %.203 = getelementptr double, ptr %.198, i64 %.139
  %.210 = add nsw i64 %.124, 1
  %.212 = getelementptr double, ptr %.203, i64 %.210
  %.221 = getelementptr double, ptr %.212, i64 %.210
  %.226 = getelementptr i8, ptr %arg.layout, i64 56
  %.227 = load i64, ptr %.226, align 8
  %.229 = getelementptr double, ptr %.221, i64 %.227
  %.237 = getelementptr double, ptr %.229, i64 %.227
  store i64 0, ptr %.243, align 8
  %.247 = call i32 @moving_groups.62(ptr nonnull %.243, ptr nonnull %excinfo.1, ptr nonnull %arg.layout)
  switch i32 %.247, label %B0.if [
    i32 -2, label %B0.endif
    i32 0, label %B0.endif
  ]

B1370:
  %.5881176 = icmp sgt i64 %arg.step_count, 0
  br i1 %.5881176, label %B1408.lr.ph, label %B5772

B1408.lr.ph:
  %.534.11179 = add nsw i64 %arg.step_count, -1
  %.773 = getelementptr i8, ptr %arg.method, i64 1344
  %.815 = getelementptr double, ptr %arg.Y, i64 %.126
  %.889 = icmp sgt i64 %.112, 0
  %storemerge908 = select i1 %.889, i64 %.142, i64 0
  %.9311111 = icmp sgt i64 %storemerge908, 0
  %.10581127.not = icmp slt i64 %arg.directions, 1
  %storemerge926 = call i64 @llvm.smax.i64(i64 %.112, i64 0)
  %.14751119.not = icmp slt i64 %arg.entry_count, 1
  %.16111124.not = icmp slt i64 %.129, 1
  %.20371130.not = icmp slt i64 %.112, 1
  %.23891136 = icmp sgt i64 %storemerge908, 0
  %.2561 = shl i64 %.112, 6
  %.27251152.not = icmp slt i64 %arg.directions, 1
  %.31821149.not = icmp slt i64 %.112, 1
  %.33821155.not = icmp slt i64 %.129, 1
  %3 = getelementptr double, ptr %.193, i64 %.137
  %.3606.idx = mul i64 %.112, 448
  %.3606 = getelementptr i8, ptr %.272, i64 %.3606.idx
  %.3794 = getelementptr double, ptr %.143, i64 %.142
  %.39061160 = icmp sgt i64 %storemerge908, 0
  %.4113 = shl i64 %.112, 6
  %.42271170.not = icmp slt i64 %arg.directions, 1
  %.44291167.not = icmp slt i64 %.112, 1
  %4 = mul i64 %.257, %arg.directions
  %5 = shl i64 %4, 3
  %6 = mul i64 %.112, 800
  %7 = mul i64 %arg.blocks, 48
  %8 = mul i64 %.115, 24
  %9 = add i64 %.129, %.124
  %10 = add i64 %9, %.227
  %11 = shl i64 %10, 4
  %12 = getelementptr i8, ptr %arg.work, i64 %5
  %13 = getelementptr i8, ptr %12, i64 %6
  %14 = getelementptr i8, ptr %13, i64 %7
  %15 = getelementptr i8, ptr %14, i64 %8
  %16 = getelementptr i8, ptr %15, i64 %11
  %scevgep = getelementptr i8, ptr %16, i64 40
  %17 = shl nuw i64 %storemerge908, 3
  %18 = shl nuw i64 %storemerge926, 3
  %19 = add i64 %arg.edge_count, -1
  br label %B1408

B1408:
  %.578.sroa.0.01183 = phi i64 [ 0, %B1408.lr.ph ], [ %.578.sroa.0.0, %B5714.endif ]
  %.534.11182 = phi i64 [ %.534.11179, %B1408.lr.ph ], [ %.534.1, %B5714.endif ]
  %.531.11181 = phi i64 [ 1, %B1408.lr.ph ], [ %.531.1, %B5714.endif ]
  %start.2.01180 = phi i64 [ 0, %B1408.lr.ph ], [ %stop.3.2, %B5714.endif ]
  %.631 = mul nsw i64 %.578.sroa.0.01183, %arg.step_length
  %.633 = getelementptr double, ptr %arg.record, i64 %.631
  %.639 = load double, ptr %.633, align 8
  %.641 = getelementptr i8, ptr %.633, i64 8
  %.642 = load double, ptr %.641, align 8
  %.644 = getelementptr i8, ptr %.633, i64 24
  store ptr null, ptr %.748, align 8
  %.752 = call i32 @replay.50(ptr nonnull %.748, ptr nonnull %excinfo.4, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.pos, ptr %arg.numbers, ptr %arg.drive_rows, ptr %arg.drive_columns, i64 %arg.blocks, ptr %arg.own, ptr %arg.slots, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %arg.mass, ptr %arg.method, ptr nonnull %.633, i64 %arg.step_length, ptr %arg.Y, ptr %arg.work, ptr %.143, ptr %.193, ptr %.203, ptr %.160, ptr %.187, ptr %.152, ptr %.156, ptr %.173, ptr %.180, ptr %.221, ptr %.229)
  switch i32 %.752, label %B1408.if [
    i32 -2, label %B1408.endif
    i32 0, label %B1408.endif
  ]

B1884.preheader:
  br i1 %.10581127.not, label %B2654.if.preheader, label %B1886.if

B2654.if.preheader:
  br label %B2654.if

B1884.loopexit:
  %exitcond1394.not = icmp eq i64 %arg.directions, %.1071
  br i1 %exitcond1394.not, label %B2654.if.preheader, label %B1886.if

B2046:
  %.1251.idx = shl i64 %.1001.01128, 4
  %.1251 = getelementptr i8, ptr %arg.ends_dot, i64 %.1251.idx
  store double 0.000000e+00, ptr %.1253, align 8
  %.1257 = call i32 @begin_rate.63(ptr nonnull %.1253, ptr nonnull %excinfo.7, i64 %.578.sroa.0.01183, ptr %.1251)
  switch i32 %.1257, label %B2046.if [
    i32 -2, label %B2046.endif
    i32 0, label %B2046.endif
  ]

B2392:
  %invariant.gep1122 = getelementptr double, ptr %.291, i64 %.1001.01128
  br i1 %.16111124.not, label %B1884.loopexit, label %B2422.if

B2902:
  store ptr null, ptr %.1932, align 8
  %.1936 = call i32 @jacobian.4(ptr nonnull %.1932, ptr nonnull %excinfo.13, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.pos, ptr %arg.numbers, ptr %arg.Y, ptr %.193, ptr %.221, ptr %.229)
  switch i32 %.1936, label %B2902.if [
    i32 -2, label %B2948
    i32 0, label %B2948
  ]

B2948:
  br i1 %.20371130.not, label %B2994, label %B2978.if.preheader

B2978.if.preheader:
  call void @llvm.memset.p0.i64(ptr align 8 %.156, i8 0, i64 %18, i1 false)
  br label %B2994

B2994:
  %.21631133.not = icmp eq i64 %.1727.01158, 0
  br i1 %.21631133.not, label %B3148, label %B3024.if.lr.ph

B3024.if.lr.ph:
  %.idx925 = shl i64 %.1727.01158, 6
  %20 = getelementptr i8, ptr %arg.method, i64 %.idx925
  %21 = getelementptr i8, ptr %20, i64 512
  br label %B3024.if

B3148:
  store ptr null, ptr %.2255, align 8
  %.2259 = call i32 @add_scaled.29(ptr nonnull %.2255, ptr nonnull %excinfo.15, i64 %.112, double %.780, ptr %.1829, ptr %.156)
  switch i32 %.2259, label %B3148.if [
    i32 -2, label %B3148.endif
    i32 0, label %B3148.endif
  ]

B3350.preheader:
  %.25221139.not = icmp eq i64 %.1727.01158, 0
  br i1 %.25221139.not, label %B3600.preheader, label %B3350.if.lr.ph

B3350.if.lr.ph:
  %.idx932 = shl i64 %.1727.01158, 6
  %22 = getelementptr i8, ptr %arg.method, i64 %.idx932
  %23 = getelementptr i8, ptr %22, i64 512
  br label %B3350.if

B3600.preheader:
  br i1 %.27251152.not, label %B4334, label %B3602.if

B4020:
  store i64 0, ptr %.3033, align 8
  %.3037 = call i32 @moving_groups.62(ptr nonnull %.3033, ptr nonnull %excinfo.22, ptr nonnull %arg.layout)
  switch i32 %.3037, label %B4020.if [
    i32 -2, label %B4020.endif
    i32 0, label %B4020.endif
  ]

B4330:
  %exitcond1400.not = icmp eq i64 %arg.directions, %.2738
  br i1 %exitcond1400.not, label %B4334, label %B3602.if

B4334:
  store ptr null, ptr %.3276, align 8
  %.3280 = call i32 @multiply_sides.64(ptr nonnull %.3276, ptr nonnull %excinfo.24, i64 %arg.entry_count, ptr %arg.entry_rows, ptr %arg.entry_columns, ptr %arg.entry_places, ptr %.193, ptr %.311, ptr %.1829, ptr %.277, ptr %.287)
  switch i32 %.3280, label %B4334.if [
    i32 -2, label %B4334.endif
    i32 0, label %B4334.endif
  ]

B4598:
  %.3478.idx = shl i64 %.1827, 6
  %.3478 = getelementptr i8, ptr %.272, i64 %.3478.idx
  store ptr null, ptr %.3488, align 8
  %.3492 = call i32 @lu_solve_sides.37(ptr nonnull %.3488, ptr nonnull %excinfo.26, i64 %.112, ptr %arg.slots, i64 %arg.blocks, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %.187, ptr %.287, ptr %.3478, ptr %.318)
  switch i32 %.3492, label %B4598.if [
    i32 -2, label %B4598.endif
    i32 0, label %B4598.endif
  ]

B4700:
  %.3531 = icmp slt i64 %start.2.01180, %arg.edge_count
  br i1 %.3531, label %B4716, label %B4822

B4716:
  %.3542 = getelementptr double, ptr %arg.edges, i64 %start.2.01180
  %.3543 = load double, ptr %.3542, align 8
  %.3547 = getelementptr i8, ptr %.633, i64 16
  %.3548 = load double, ptr %.3547, align 8
  %.3549 = fmul contract double %.3548, 0x3FF0000000000005
  %.3550 = fcmp contract ugt double %.3543, %.3549
  br i1 %.3550, label %B4822, label %B4758

B4758:
  %stop.2.1 = phi i64 [ %.3556, %B4780 ], [ %start.2.01180, %B4716 ]
  %exitcond1403.not = icmp eq i64 %stop.2.1, %19
  br i1 %exitcond1403.not, label %B4822, label %B4780

B4780:
  %.3556 = add nsw i64 %stop.2.1, 1
  %.3577 = getelementptr double, ptr %arg.edges, i64 %.3556
  %.3578 = load double, ptr %.3577, align 8
  %.3585 = fcmp contract ugt double %.3578, %.3549
  br i1 %.3585, label %B4822, label %B4758

B4822:
  %stop.3.2 = phi i64 [ %start.2.01180, %B4716 ], [ %start.2.01180, %B4700 ], [ %arg.edge_count, %B4758 ], [ %.3556, %B4780 ]
  store ptr null, ptr %.3608, align 8
  %.3612 = call i32 @add_scaled.29(ptr nonnull %.3608, ptr nonnull %excinfo.27, i64 %.142, double 1.000000e+00, ptr %.3606, ptr %.277)
  switch i32 %.3612, label %B4822.if [
    i32 -2, label %B4822.endif
    i32 0, label %B4822.endif
  ]

B4972.loopexit:
  %.3716 = icmp sgt i64 %.3662.01175, 1
  br i1 %.3716, label %B4974.if, label %B5714

B5430.preheader:
  br i1 %.42271170.not, label %B4972.loopexit, label %B5430.if

B5430.loopexit:
  %exitcond1407.not = icmp eq i64 %arg.directions, %.4240
  br i1 %exitcond1407.not, label %B4972.loopexit, label %B5430.if

B5714:
  store ptr null, ptr %.4520, align 8
  %.4524 = call i32 @copy.27(ptr nonnull %.4520, ptr nonnull %excinfo.34, i64 %.142, ptr %.277, ptr %arg.y_dot)
  switch i32 %.4524, label %B5714.if [
    i32 -2, label %B5714.endif
    i32 0, label %B5714.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ 0, %B5772 ], [ %.4305, %B5432.endif.if ], [ %.4524, %B5714.if ], [ %.247, %B0.if ], [ %.451, %B1238.if ], [ %.3445, %B4412.if ], [ %.479, %B1238.endif.if ], [ %.752, %B1408.if ], [ %.792, %B1408.endif.endif.if ], [ %.4278, %B5432.if ], [ %.4122, %B5260.endif.if ], [ %.2872, %B3604.endif.endif.if ], [ %.830, %B1408.endif.endif.endif.if ], [ %.1257, %B2046.if ], [ %.1299, %B2046.endif.if ], [ %.1335, %B2046.endif.endif.if ], [ %.4089, %B5260.if ], [ %.3805, %B4976.endif.if ], [ %.3037, %B4020.if ], [ %.1371, %B2046.endif.endif.endif.if ], [ %.1853, %B2656.if ], [ %.1899, %B2656.endif.if ], [ %.3280, %B4334.if ], [ %.3767, %B4976.if ], [ %.1936, %B2902.if ], [ %.2225, %B3026.endif.if ], [ %.2259, %B3148.if ], [ %.3612, %B4822.if ], [ %.3077, %B4020.endif.if ], [ %.2288, %B3148.endif.if ], [ %.2579, %B3352.if ], [ %.3492, %B4598.if ], [ %.2619, %B3352.endif.endif.if ], [ %.2793, %B3604.if ], [ %.2822, %B3604.endif.if ]
  ret i32 %common.ret.op

B5772:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B0.if:
  %.255 = icmp sgt i32 %.247, 0
  %.248 = load ptr, ptr %excinfo.1, align 8
  %.256 = select i1 %.255, ptr %.248, ptr undef
  store ptr %.256, ptr %excinfo, align 8
  br label %common.ret

B0.endif:
  %.257 = load i64, ptr %.243, align 8
  %.270 = mul nsw i64 %.257, %arg.directions
  %.272 = getelementptr double, ptr %.237, i64 %.270
  %.277.idx = shl i64 %.112, 9
  %.277 = getelementptr i8, ptr %.272, i64 %.277.idx
  %.287.idx = mul i64 %.112, 576
  %.287 = getelementptr i8, ptr %.272, i64 %.287.idx
  %.291.idx = mul i64 %.112, 640
  %.291 = getelementptr i8, ptr %.272, i64 %.291.idx
  %.301.idx = mul i64 %.112, 704
  %.301 = getelementptr i8, ptr %.272, i64 %.301.idx
  %.307 = load i64, ptr %.123, align 8
  %.idx906 = shl i64 %.307, 6
  %24 = getelementptr i8, ptr %.301, i64 %.idx906
  %.311 = getelementptr i8, ptr %24, i64 64
  %.318.idx = shl i64 %arg.entry_count, 6
  %.318 = getelementptr i8, ptr %.311, i64 %.318.idx
  %.4021108.not = icmp slt i64 %arg.directions, 1
  br i1 %.4021108.not, label %B1370, label %B1236.if

B1236.if:
  %.346.01109 = phi i64 [ %.415, %B1238.endif.endif ], [ 0, %B0.endif ]
  %.415 = add nuw nsw i64 %.346.01109, 1
  store i64 0, ptr %.447, align 8
  %.451 = call i32 @moving_groups.62(ptr nonnull %.447, ptr nonnull %excinfo.2, ptr nonnull %arg.layout)
  switch i32 %.451, label %B1238.if [
    i32 -2, label %B1238.endif
    i32 0, label %B1238.endif
  ]

B1238.if:
  %.459 = icmp sgt i32 %.451, 0
  %.452 = load ptr, ptr %excinfo.2, align 8
  %.460 = select i1 %.459, ptr %.452, ptr undef
  store ptr %.460, ptr %excinfo, align 8
  br label %common.ret

B1238.endif:
  %.461 = load i64, ptr %.447, align 8
  %.442 = mul nsw i64 %.346.01109, %arg.numbers_length
  %.444 = getelementptr double, ptr %arg.numbers_dot, i64 %.442
  %.471 = mul nsw i64 %.461, %.346.01109
  %.473 = getelementptr double, ptr %.237, i64 %.471
  store ptr null, ptr %.475, align 8
  %.479 = call i32 @mark_moving.65(ptr nonnull %.475, ptr nonnull %excinfo.3, ptr nonnull %arg.layout, ptr %.444, ptr %.473)
  switch i32 %.479, label %B1238.endif.if [
    i32 -2, label %B1238.endif.endif
    i32 0, label %B1238.endif.endif
  ]

B1238.endif.if:
  %.487 = icmp sgt i32 %.479, 0
  %.480 = load ptr, ptr %excinfo.3, align 8
  %.488 = select i1 %.487, ptr %.480, ptr undef
  store ptr %.488, ptr %excinfo, align 8
  br label %common.ret

B1238.endif.endif:
  %exitcond.not = icmp eq i64 %arg.directions, %.415
  br i1 %exitcond.not, label %B1370, label %B1236.if

B1408.if:
  %.760 = icmp sgt i32 %.752, 0
  %.753 = load ptr, ptr %excinfo.4, align 8
  %.761 = select i1 %.760, ptr %.753, ptr undef
  store ptr %.761, ptr %excinfo, align 8
  br label %common.ret

B1408.endif:
  %.774 = load double, ptr %.773, align 8
  %.776 = fmul contract double %.642, %.774
  %.780 = fdiv contract double 1.000000e+00, %.776
  store ptr null, ptr %.788, align 8
  %.792 = call i32 @copy.27(ptr nonnull %.788, ptr nonnull %excinfo.5, i64 %.112, ptr %.644, ptr %arg.Y)
  switch i32 %.792, label %B1408.endif.endif.if [
    i32 -2, label %B1408.endif.endif.endif
    i32 0, label %B1408.endif.endif.endif
  ]

B1408.endif.endif.if:
  %.800 = icmp sgt i32 %.792, 0
  %.793 = load ptr, ptr %excinfo.5, align 8
  %.801 = select i1 %.800, ptr %.793, ptr undef
  store ptr %.801, ptr %excinfo, align 8
  br label %common.ret

B1408.endif.endif.endif:
  store double %.639, ptr %.815, align 8
  store ptr null, ptr %.826, align 8
  %.830 = call i32 @drive.6(ptr nonnull %.826, ptr nonnull %excinfo.6, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.221, ptr %.229)
  switch i32 %.830, label %B1408.endif.endif.endif.if [
    i32 -2, label %B1408.endif.endif.endif.endif
    i32 0, label %B1408.endif.endif.endif.endif
  ]

B1408.endif.endif.endif.if:
  %.838 = icmp sgt i32 %.830, 0
  %.831 = load ptr, ptr %excinfo.6, align 8
  %.839 = select i1 %.838, ptr %.831, ptr undef
  store ptr %.839, ptr %excinfo, align 8
  br label %common.ret

B1408.endif.endif.endif.endif:
  br i1 %.9311111, label %B1838.if.preheader, label %B1884.preheader

B1838.if.preheader:
  call void @llvm.memset.p0.i64(ptr align 8 %scevgep, i8 0, i64 %17, i1 false)
  br label %B1884.preheader

B1886.if:
  %.1001.01128 = phi i64 [ %.1071, %B1884.loopexit ], [ 0, %B1884.preheader ]
  %.1071 = add nuw nsw i64 %.1001.01128, 1
  %.1101 = mul nsw i64 %.1001.01128, %arg.Y_length
  %.1103 = getelementptr double, ptr %arg.Y_dot, i64 %.1101
  %.1106 = mul nsw i64 %.1001.01128, %arg.numbers_length
  %.1108 = getelementptr double, ptr %arg.numbers_dot, i64 %.1106
  %invariant.gep = getelementptr double, ptr %arg.y_dot, i64 %.1001.01128
  br i1 %.889, label %B1996.if, label %B2046

B1996.if:
  %.1139.01115 = phi i64 [ %.1208, %B1996.if ], [ 0, %B1886.if ]
  %.1208 = add nuw nsw i64 %.1139.01115, 1
  %.idx931 = shl i64 %.1139.01115, 6
  %gep = getelementptr i8, ptr %invariant.gep, i64 %.idx931
  %.1238 = load double, ptr %gep, align 8
  %.1240 = getelementptr double, ptr %.1103, i64 %.1139.01115
  store double %.1238, ptr %.1240, align 8
  %exitcond1391.not = icmp eq i64 %.112, %.1208
  br i1 %exitcond1391.not, label %B2046, label %B1996.if

B2046.if:
  %.1265 = icmp sgt i32 %.1257, 0
  %.1258 = load ptr, ptr %excinfo.7, align 8
  %.1266 = select i1 %.1265, ptr %.1258, ptr undef
  store ptr %.1266, ptr %excinfo, align 8
  br label %common.ret

B2046.endif:
  %.1267 = load double, ptr %.1253, align 8
  %.1279 = getelementptr double, ptr %.1103, i64 %.126
  store double %.1267, ptr %.1279, align 8
  %.1284 = getelementptr double, ptr %.1103, i64 %.112
  store ptr null, ptr %.1295, align 8
  %.1299 = call i32 @push_drive.46(ptr nonnull %.1295, ptr nonnull %excinfo.8, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, i64 0, ptr %.1103, ptr %.1108, ptr %.1284, ptr %.221, ptr %.229)
  switch i32 %.1299, label %B2046.endif.if [
    i32 -2, label %B2046.endif.endif
    i32 0, label %B2046.endif.endif
  ]

B2046.endif.if:
  %.1307 = icmp sgt i32 %.1299, 0
  %.1300 = load ptr, ptr %excinfo.8, align 8
  %.1308 = select i1 %.1307, ptr %.1300, ptr undef
  store ptr %.1308, ptr %excinfo, align 8
  br label %common.ret

B2046.endif.endif:
  store ptr null, ptr %.1331, align 8
  %.1335 = call i32 @push_drive.66(ptr nonnull %.1331, ptr nonnull %excinfo.9, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, i64 1, ptr %.1103, ptr %.1108, ptr %.212, ptr %.221, ptr %.229)
  switch i32 %.1335, label %B2046.endif.endif.if [
    i32 -2, label %B2046.endif.endif.endif
    i32 0, label %B2046.endif.endif.endif
  ]

B2046.endif.endif.if:
  %.1343 = icmp sgt i32 %.1335, 0
  %.1336 = load ptr, ptr %excinfo.9, align 8
  %.1344 = select i1 %.1343, ptr %.1336, ptr undef
  store ptr %.1344, ptr %excinfo, align 8
  br label %common.ret

B2046.endif.endif.endif:
  store ptr null, ptr %.1367, align 8
  %.1371 = call i32 @push_jacobian.67(ptr nonnull %.1367, ptr nonnull %excinfo.10, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.pos, ptr %arg.numbers, ptr %arg.Y, ptr %.1103, ptr %.1108, ptr %.198, ptr %.221, ptr %.229)
  switch i32 %.1371, label %B2046.endif.endif.endif.if [
    i32 -2, label %B2046.endif.endif.endif.endif
    i32 0, label %B2046.endif.endif.endif.endif
  ]

B2046.endif.endif.endif.if:
  %.1379 = icmp sgt i32 %.1371, 0
  %.1372 = load ptr, ptr %excinfo.10, align 8
  %.1380 = select i1 %.1379, ptr %.1372, ptr undef
  store ptr %.1380, ptr %excinfo, align 8
  br label %common.ret

B2046.endif.endif.endif.endif:
  %invariant.gep1117 = getelementptr double, ptr %.311, i64 %.1001.01128
  br i1 %.14751119.not, label %B2392, label %B2330.if

B2330.if:
  %.1419.01120 = phi i64 [ %.1488, %B2330.if ], [ 0, %B2046.endif.endif.endif.endif ]
  %.1488 = add nuw nsw i64 %.1419.01120, 1
  %.1514 = getelementptr i32, ptr %arg.entry_places, i64 %.1419.01120
  %.1515 = load i32, ptr %.1514, align 4
  %.1517 = sext i32 %.1515 to i64
  %.1518 = getelementptr double, ptr %.198, i64 %.1517
  %.1519 = load double, ptr %.1518, align 8
  %.idx930 = shl i64 %.1419.01120, 6
  %gep1118 = getelementptr i8, ptr %invariant.gep1117, i64 %.idx930
  store double %.1519, ptr %gep1118, align 8
  %exitcond1392.not = icmp eq i64 %arg.entry_count, %.1488
  br i1 %exitcond1392.not, label %B2392, label %B2330.if

B2422.if:
  %.1555.01125 = phi i64 [ %.1624, %B2422.if ], [ 0, %B2392 ]
  %.1624 = add nuw nsw i64 %.1555.01125, 1
  %.1650 = getelementptr i32, ptr %arg.drive_rows, i64 %.1555.01125
  %.1651 = load i32, ptr %.1650, align 4
  %.1652 = sext i32 %.1651 to i64
  %.idx929 = shl nsw i64 %.1652, 6
  %gep1123 = getelementptr i8, ptr %invariant.gep1122, i64 %.idx929
  %.1658 = load double, ptr %gep1123, align 8
  %.1661 = add nsw i64 %.1555.01125, %.137
  %.1663 = getelementptr double, ptr %.198, i64 %.1661
  %.1664 = load double, ptr %.1663, align 8
  %.1666 = getelementptr i32, ptr %arg.drive_columns, i64 %.1555.01125
  %.1667 = load i32, ptr %.1666, align 4
  %.1669 = sext i32 %.1667 to i64
  %.1670 = getelementptr double, ptr %.203, i64 %.1669
  %.1671 = load double, ptr %.1670, align 8
  %.1672 = fmul contract double %.1664, %.1671
  %.1677 = getelementptr double, ptr %.193, i64 %.1661
  %.1678 = load double, ptr %.1677, align 8
  %.1684 = getelementptr double, ptr %.212, i64 %.1669
  %.1685 = load double, ptr %.1684, align 8
  %.1686 = fmul contract double %.1678, %.1685
  %.1687 = fadd contract double %.1672, %.1686
  %.1688 = fadd contract double %.1658, %.1687
  store double %.1688, ptr %gep1123, align 8
  %exitcond1393.not = icmp eq i64 %.129, %.1624
  br i1 %exitcond1393.not, label %B1884.loopexit, label %B2422.if

B2654.if:
  %.1727.01158 = phi i64 [ %.1797, %B4598.endif ], [ 0, %B2654.if.preheader ]
  %.1797 = add nuw nsw i64 %.1727.01158, 1
  %.1827 = mul nsw i64 %.1727.01158, %.112
  %.1829 = getelementptr double, ptr %arg.work, i64 %.1827
  %25 = getelementptr double, ptr %arg.method, i64 %.1727.01158
  %.1833 = getelementptr i8, ptr %25, i64 1088
  %.1834 = load double, ptr %.1833, align 8
  %.1846 = getelementptr double, ptr %.143, i64 %.1827
  store ptr null, ptr %.1849, align 8
  %.1853 = call i32 @copy.27(ptr nonnull %.1849, ptr nonnull %excinfo.11, i64 %.112, ptr %.1846, ptr %arg.Y)
  switch i32 %.1853, label %B2656.if [
    i32 -2, label %B2656.endif
    i32 0, label %B2656.endif
  ]

B2656.if:
  %.1861 = icmp sgt i32 %.1853, 0
  %.1854 = load ptr, ptr %excinfo.11, align 8
  %.1862 = select i1 %.1861, ptr %.1854, ptr undef
  store ptr %.1862, ptr %excinfo, align 8
  br label %common.ret

B2656.endif:
  %.1876 = getelementptr i8, ptr %25, i64 1024
  %.1877 = load double, ptr %.1876, align 8
  %.1879 = fmul contract double %.642, %.1877
  %.1881 = fadd contract double %.639, %.1879
  store double %.1881, ptr %.815, align 8
  store ptr null, ptr %.1895, align 8
  %.1899 = call i32 @drive.6(ptr nonnull %.1895, ptr nonnull %excinfo.12, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.221, ptr %.229)
  switch i32 %.1899, label %B2656.endif.if [
    i32 -2, label %B2656.endif.endif
    i32 0, label %B2656.endif.endif
  ]

B2656.endif.if:
  %.1907 = icmp sgt i32 %.1899, 0
  %.1900 = load ptr, ptr %excinfo.12, align 8
  %.1908 = select i1 %.1907, ptr %.1900, ptr undef
  store ptr %.1908, ptr %excinfo, align 8
  br label %common.ret

B2656.endif.endif:
  %.1920.not = icmp eq i64 %.1727.01158, 0
  br i1 %.1920.not, label %B2948, label %B2902

B2902.if:
  %.1944 = icmp sgt i32 %.1936, 0
  %.1937 = load ptr, ptr %excinfo.13, align 8
  %.1945 = select i1 %.1944, ptr %.1937, ptr undef
  store ptr %.1945, ptr %excinfo, align 8
  br label %common.ret

B3024.if:
  %.2107.01134 = phi i64 [ 0, %B3024.if.lr.ph ], [ %.2176, %B3026.endif.endif ]
  %.2207 = getelementptr double, ptr %21, i64 %.2107.01134
  %.2208 = load double, ptr %.2207, align 8
  %.2209 = fneg contract double %.2208
  %.2214 = fdiv contract double %.2209, %.642
  %.2216 = mul nsw i64 %.2107.01134, %.112
  %.2218 = getelementptr double, ptr %arg.work, i64 %.2216
  store ptr null, ptr %.2221, align 8
  %.2225 = call i32 @add_scaled.29(ptr nonnull %.2221, ptr nonnull %excinfo.14, i64 %.112, double %.2214, ptr %.2218, ptr %.156)
  switch i32 %.2225, label %B3026.endif.if [
    i32 -2, label %B3026.endif.endif
    i32 0, label %B3026.endif.endif
  ]

B3026.endif.if:
  %.2233 = icmp sgt i32 %.2225, 0
  %.2226 = load ptr, ptr %excinfo.14, align 8
  %.2234 = select i1 %.2233, ptr %.2226, ptr undef
  store ptr %.2234, ptr %excinfo, align 8
  br label %common.ret

B3026.endif.endif:
  %.2176 = add nuw nsw i64 %.2107.01134, 1
  %exitcond1395.not = icmp eq i64 %.2176, %.1727.01158
  br i1 %exitcond1395.not, label %B3148, label %B3024.if

B3148.if:
  %.2267 = icmp sgt i32 %.2259, 0
  %.2260 = load ptr, ptr %excinfo.15, align 8
  %.2268 = select i1 %.2267, ptr %.2260, ptr undef
  store ptr %.2268, ptr %excinfo, align 8
  br label %common.ret

B3148.endif:
  store ptr null, ptr %.2284, align 8
  %.2288 = call i32 @copy.27(ptr nonnull %.2284, ptr nonnull %excinfo.16, i64 %.142, ptr %arg.y_dot, ptr %.277)
  switch i32 %.2288, label %B3148.endif.if [
    i32 -2, label %B3148.endif.endif
    i32 0, label %B3148.endif.endif
  ]

B3148.endif.if:
  %.2296 = icmp sgt i32 %.2288, 0
  %.2289 = load ptr, ptr %excinfo.16, align 8
  %.2297 = select i1 %.2296, ptr %.2289, ptr undef
  store ptr %.2297, ptr %excinfo, align 8
  br label %common.ret

B3148.endif.endif:
  br i1 %.23891136, label %B3280.if.lr.ph, label %B3350.preheader

B3280.if.lr.ph:
  %.2429 = fmul contract double %.642, %.1834
  br label %B3280.if

B3280.if:
  %.2333.01137 = phi i64 [ 0, %B3280.if.lr.ph ], [ %.2402, %B3280.if ]
  %.2402 = add nuw nsw i64 %.2333.01137, 1
  %.2431 = getelementptr double, ptr %.291, i64 %.2333.01137
  %.2432 = load double, ptr %.2431, align 8
  %.2433 = fmul contract double %.2429, %.2432
  %.2435 = getelementptr double, ptr %.287, i64 %.2333.01137
  store double %.2433, ptr %.2435, align 8
  %exitcond1396.not = icmp eq i64 %.2402, %storemerge908
  br i1 %exitcond1396.not, label %B3350.preheader, label %B3280.if

B3350.if:
  %.2466.01140 = phi i64 [ 0, %B3350.if.lr.ph ], [ %.2535, %B3352.endif.endif.endif ]
  %.2535 = add nuw nsw i64 %.2466.01140, 1
  %.2564.idx = mul i64 %.2561, %.2466.01140
  %.2564 = getelementptr i8, ptr %.272, i64 %.2564.idx
  %.2572 = getelementptr double, ptr %22, i64 %.2466.01140
  %.2573 = load double, ptr %.2572, align 8
  store ptr null, ptr %.2575, align 8
  %.2579 = call i32 @add_scaled.29(ptr nonnull %.2575, ptr nonnull %excinfo.17, i64 %.142, double %.2573, ptr %.2564, ptr %.277)
  switch i32 %.2579, label %B3352.if [
    i32 -2, label %B3352.endif
    i32 0, label %B3352.endif
  ]

B3352.if:
  %.2587 = icmp sgt i32 %.2579, 0
  %.2580 = load ptr, ptr %excinfo.17, align 8
  %.2588 = select i1 %.2587, ptr %.2580, ptr undef
  store ptr %.2588, ptr %excinfo, align 8
  br label %common.ret

B3352.endif:
  %.2605 = getelementptr double, ptr %23, i64 %.2466.01140
  %.2606 = load double, ptr %.2605, align 8
  %.2611 = fdiv contract double %.2606, %.642
  store ptr null, ptr %.2615, align 8
  %.2619 = call i32 @add_masses.68(ptr nonnull %.2615, ptr nonnull %excinfo.18, i64 %.112, ptr %arg.mass, double %.2611, ptr %.2564, ptr %.287)
  switch i32 %.2619, label %B3352.endif.endif.if [
    i32 -2, label %B3352.endif.endif.endif
    i32 0, label %B3352.endif.endif.endif
  ]

B3352.endif.endif.if:
  %.2627 = icmp sgt i32 %.2619, 0
  %.2620 = load ptr, ptr %excinfo.18, align 8
  %.2628 = select i1 %.2627, ptr %.2620, ptr undef
  store ptr %.2628, ptr %excinfo, align 8
  br label %common.ret

B3352.endif.endif.endif:
  %exitcond1397.not = icmp eq i64 %.2535, %.1727.01158
  br i1 %exitcond1397.not, label %B3600.preheader, label %B3350.if

B3602.if:
  %.2668.01153 = phi i64 [ %.2738, %B4330 ], [ 0, %B3600.preheader ]
  %.2738 = add nuw nsw i64 %.2668.01153, 1
  %.2768 = mul nsw i64 %.2668.01153, %arg.Y_length
  %.2770 = getelementptr double, ptr %arg.Y_dot, i64 %.2768
  %.2773 = mul nsw i64 %.2668.01153, %arg.numbers_length
  %.2775 = getelementptr double, ptr %arg.numbers_dot, i64 %.2773
  %.2785.idx = shl i64 %.2668.01153, 4
  %.2785 = getelementptr i8, ptr %arg.ends_dot, i64 %.2785.idx
  store double 0.000000e+00, ptr %.2789, align 8
  %.2793 = call i32 @size_rate.69(ptr nonnull %.2789, ptr nonnull %excinfo.19, i64 %.578.sroa.0.01183, i64 %arg.step_count, ptr %.2785)
  %.2803 = load double, ptr %.2789, align 8
  switch i32 %.2793, label %B3604.if [
    i32 -2, label %B3604.endif
    i32 0, label %B3604.endif
  ]

B3604.if:
  %.2801 = icmp sgt i32 %.2793, 0
  %.2794 = load ptr, ptr %excinfo.19, align 8
  %.2802 = select i1 %.2801, ptr %.2794, ptr undef
  store ptr %.2802, ptr %excinfo, align 8
  br label %common.ret

B3604.endif:
  store double 0.000000e+00, ptr %.2818, align 8
  %.2822 = call i32 @begin_rate.63(ptr nonnull %.2818, ptr nonnull %excinfo.20, i64 %.578.sroa.0.01183, ptr %.2785)
  switch i32 %.2822, label %B3604.endif.if [
    i32 -2, label %B3604.endif.endif
    i32 0, label %B3604.endif.endif
  ]

B3604.endif.if:
  %.2830 = icmp sgt i32 %.2822, 0
  %.2823 = load ptr, ptr %excinfo.20, align 8
  %.2831 = select i1 %.2830, ptr %.2823, ptr undef
  store ptr %.2831, ptr %excinfo, align 8
  br label %common.ret

B3604.endif.endif:
  %.2832 = load double, ptr %.2818, align 8
  %.2846 = load double, ptr %.1876, align 8
  %.2848 = fmul contract double %.2803, %.2846
  %.2849 = fadd contract double %.2832, %.2848
  %.2852 = getelementptr double, ptr %.2770, i64 %.126
  store double %.2849, ptr %.2852, align 8
  %.2857 = getelementptr double, ptr %.2770, i64 %.112
  store ptr null, ptr %.2868, align 8
  %.2872 = call i32 @push_drive.46(ptr nonnull %.2868, ptr nonnull %excinfo.21, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, i64 0, ptr %.2770, ptr %.2775, ptr %.2857, ptr %.221, ptr %.229)
  switch i32 %.2872, label %B3604.endif.endif.if [
    i32 -2, label %B3604.endif.endif.endif
    i32 0, label %B3604.endif.endif.endif
  ]

B3604.endif.endif.if:
  %.2880 = icmp sgt i32 %.2872, 0
  %.2873 = load ptr, ptr %excinfo.21, align 8
  %.2881 = select i1 %.2880, ptr %.2873, ptr undef
  store ptr %.2881, ptr %excinfo, align 8
  br label %common.ret

B3604.endif.endif.endif:
  %.2894 = load i64, ptr %.123, align 8
  %invariant.gep1142 = getelementptr double, ptr %.301, i64 %.2668.01153
  %.29741144.not = icmp slt i64 %.2894, 1
  br i1 %.29741144.not, label %B4020, label %B3964.if

B3964.if:
  %.2918.01145 = phi i64 [ %.2987, %B3964.if ], [ 0, %B3604.endif.endif.endif ]
  %.2987 = add nuw nsw i64 %.2918.01145, 1
  %.3015 = getelementptr double, ptr %.2857, i64 %.2918.01145
  %.3016 = load double, ptr %.3015, align 8
  %.idx924 = shl i64 %.2918.01145, 6
  %gep1143 = getelementptr i8, ptr %invariant.gep1142, i64 %.idx924
  store double %.3016, ptr %gep1143, align 8
  %exitcond1398.not = icmp eq i64 %.2894, %.2987
  br i1 %exitcond1398.not, label %B4020, label %B3964.if

B4020.if:
  %.3045 = icmp sgt i32 %.3037, 0
  %.3038 = load ptr, ptr %excinfo.22, align 8
  %.3046 = select i1 %.3045, ptr %.3038, ptr undef
  store ptr %.3046, ptr %excinfo, align 8
  br label %common.ret

B4020.endif:
  %.3047 = load i64, ptr %.3033, align 8
  %.3058 = mul nsw i64 %.3047, %.2668.01153
  %.3060 = getelementptr double, ptr %.237, i64 %.3058
  %.3063 = getelementptr double, ptr %.287, i64 %.2668.01153
  store ptr null, ptr %.3073, align 8
  %.3077 = call i32 @push_numbers.70(ptr nonnull %.3073, ptr nonnull %excinfo.23, ptr nonnull %arg.layout, ptr %arg.derived, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.2775, ptr %.3060, ptr %.3063, ptr %.221, ptr %.229)
  switch i32 %.3077, label %B4020.endif.if [
    i32 -2, label %B4020.endif.endif
    i32 0, label %B4020.endif.endif
  ]

B4020.endif.if:
  %.3085 = icmp sgt i32 %.3077, 0
  %.3078 = load ptr, ptr %excinfo.23, align 8
  %.3086 = select i1 %.3085, ptr %.3078, ptr undef
  store ptr %.3086, ptr %excinfo, align 8
  br label %common.ret

B4020.endif.endif:
  %.3100 = fcmp contract une double %.2803, 0.000000e+00
  br i1 %.3100, label %B4200.preheader, label %B4330

B4200.preheader:
  %invariant.gep1147 = getelementptr double, ptr %.287, i64 %.2668.01153
  br i1 %.31821149.not, label %B4330, label %B4200.if

B4200.if:
  %.3126.01150 = phi i64 [ %.3195, %B4200.if ], [ 0, %B4200.preheader ]
  %.3195 = add nuw nsw i64 %.3126.01150, 1
  %.3221 = getelementptr double, ptr %arg.mass, i64 %.3126.01150
  %.3222 = load double, ptr %.3221, align 8
  %.3227 = fdiv contract double %.3222, %.642
  %.3229 = getelementptr double, ptr %.156, i64 %.3126.01150
  %.3230 = load double, ptr %.3229, align 8
  %.3231 = fmul contract double %.3227, %.3230
  %.3233 = getelementptr double, ptr %.160, i64 %.3126.01150
  %.3234 = load double, ptr %.3233, align 8
  %.3236 = fmul contract double %.1834, %.3234
  %.3237 = fadd contract double %.3231, %.3236
  %.idx923 = shl i64 %.3126.01150, 6
  %gep1148 = getelementptr i8, ptr %invariant.gep1147, i64 %.idx923
  %.3243 = load double, ptr %gep1148, align 8
  %.3245 = fmul contract double %.2803, %.3237
  %.3246 = fadd contract double %.3243, %.3245
  store double %.3246, ptr %gep1148, align 8
  %exitcond1399.not = icmp eq i64 %.112, %.3195
  br i1 %exitcond1399.not, label %B4330, label %B4200.if

B4334.if:
  %.3288 = icmp sgt i32 %.3280, 0
  %.3281 = load ptr, ptr %excinfo.24, align 8
  %.3289 = select i1 %.3288, ptr %.3281, ptr undef
  store ptr %.3289, ptr %excinfo, align 8
  br label %common.ret

B4334.endif:
  br i1 %.33821155.not, label %B4598, label %B4410.if

B4410.if:
  %.3326.01156 = phi i64 [ %.3395, %B4412.endif ], [ 0, %B4334.endif ]
  %.3425 = getelementptr double, ptr %3, i64 %.3326.01156
  %.3426 = load double, ptr %.3425, align 8
  %.3428 = getelementptr i32, ptr %arg.drive_columns, i64 %.3326.01156
  %.3429 = load i32, ptr %.3428, align 4
  %.3430 = sext i32 %.3429 to i64
  %.3433.idx = shl nsw i64 %.3430, 6
  %.3433 = getelementptr i8, ptr %.301, i64 %.3433.idx
  %.3435 = getelementptr i32, ptr %arg.drive_rows, i64 %.3326.01156
  %.3436 = load i32, ptr %.3435, align 4
  %.3437 = sext i32 %.3436 to i64
  %.3440.idx = shl nsw i64 %.3437, 6
  %.3440 = getelementptr i8, ptr %.287, i64 %.3440.idx
  store ptr null, ptr %.3441, align 8
  %.3445 = call i32 @add_scaled.71(ptr nonnull %.3441, ptr nonnull %excinfo.25, i64 8, double %.3426, ptr %.3433, ptr %.3440)
  switch i32 %.3445, label %B4412.if [
    i32 -2, label %B4412.endif
    i32 0, label %B4412.endif
  ]

B4412.if:
  %.3453 = icmp sgt i32 %.3445, 0
  %.3446 = load ptr, ptr %excinfo.25, align 8
  %.3454 = select i1 %.3453, ptr %.3446, ptr undef
  store ptr %.3454, ptr %excinfo, align 8
  br label %common.ret

B4412.endif:
  %.3395 = add nuw nsw i64 %.3326.01156, 1
  %exitcond1401.not = icmp eq i64 %.129, %.3395
  br i1 %exitcond1401.not, label %B4598, label %B4410.if

B4598.if:
  %.3500 = icmp sgt i32 %.3492, 0
  %.3493 = load ptr, ptr %excinfo.26, align 8
  %.3501 = select i1 %.3500, ptr %.3493, ptr undef
  store ptr %.3501, ptr %excinfo, align 8
  br label %common.ret

B4598.endif:
  %exitcond1402.not = icmp eq i64 %.1797, 8
  br i1 %exitcond1402.not, label %B4700, label %B2654.if

B4822.if:
  %.3620 = icmp sgt i32 %.3612, 0
  %.3613 = load ptr, ptr %excinfo.27, align 8
  %.3621 = select i1 %.3620, ptr %.3613, ptr undef
  store ptr %.3621, ptr %excinfo, align 8
  br label %common.ret

B4822.endif:
  %.3672 = sub i64 %stop.3.2, %start.2.01180
  %.37161173.not = icmp slt i64 %.3672, 1
  br i1 %.37161173.not, label %B5714, label %B4974.if

B4974.if:
  %.3662.01175 = phi i64 [ %.3725, %B4972.loopexit ], [ %.3672, %B4822.endif ]
  %.3659.01174 = phi i64 [ %.3729, %B4972.loopexit ], [ %start.2.01180, %B4822.endif ]
  %.3725 = add nsw i64 %.3662.01175, -1
  %.3729 = add i64 %.3659.01174, 1
  %.3760 = getelementptr double, ptr %arg.edges, i64 %.3659.01174
  %.3761 = load double, ptr %.3760, align 8
  store double 0.000000e+00, ptr %.3763, align 8
  %.3767 = call i32 @part_done.55(ptr nonnull %.3763, ptr nonnull %excinfo.28, double %.3761, ptr nonnull %.633)
  %.3777 = load double, ptr %.3763, align 8
  switch i32 %.3767, label %B4976.if [
    i32 -2, label %B4976.endif
    i32 0, label %B4976.endif
  ]

B4976.if:
  %.3775 = icmp sgt i32 %.3767, 0
  %.3768 = load ptr, ptr %excinfo.28, align 8
  %.3776 = select i1 %.3775, ptr %.3768, ptr undef
  store ptr %.3776, ptr %excinfo, align 8
  br label %common.ret

B4976.endif:
  store ptr null, ptr %.3801, align 8
  %.3805 = call i32 @dense_rate.52(ptr nonnull %.3801, ptr nonnull %excinfo.29, i64 %.112, ptr %arg.method, double %.3777, ptr %.644, ptr %.3794, ptr %arg.work, ptr %.152)
  switch i32 %.3805, label %B4976.endif.if [
    i32 -2, label %B4976.endif.endif
    i32 0, label %B4976.endif.endif
  ]

B4976.endif.if:
  %.3813 = icmp sgt i32 %.3805, 0
  %.3806 = load ptr, ptr %excinfo.29, align 8
  %.3814 = select i1 %.3813, ptr %.3806, ptr undef
  store ptr %.3814, ptr %excinfo, align 8
  br label %common.ret

B4976.endif.endif:
  br i1 %.39061160, label %B5154.if.lr.ph, label %B5258.if.preheader

B5154.if.lr.ph:
  %.3946 = fsub contract double 1.000000e+00, %.3777
  br label %B5154.if

B5154.if:
  %.3850.01161 = phi i64 [ 0, %B5154.if.lr.ph ], [ %.3919, %B5154.if ]
  %.3919 = add nuw nsw i64 %.3850.01161, 1
  %.3948 = getelementptr double, ptr %arg.y_dot, i64 %.3850.01161
  %.3949 = load double, ptr %.3948, align 8
  %.3950 = fmul contract double %.3946, %.3949
  %.3952 = getelementptr double, ptr %.277, i64 %.3850.01161
  %.3953 = load double, ptr %.3952, align 8
  %.3955 = fmul contract double %.3777, %.3953
  %.3956 = fadd contract double %.3950, %.3955
  %.3958 = getelementptr double, ptr %.287, i64 %.3850.01161
  store double %.3956, ptr %.3958, align 8
  %exitcond1404.not = icmp eq i64 %.3919, %storemerge908
  br i1 %exitcond1404.not, label %B5258.if.preheader, label %B5154.if

B5258.if.preheader:
  br label %B5258.if

B5258.if:
  %.3988.01163 = phi i64 [ %.4057, %B5260.endif.endif ], [ 0, %B5258.if.preheader ]
  %.4057 = add nuw nsw i64 %.3988.01163, 1
  store double 0.000000e+00, ptr %.4085, align 8
  %.4089 = call i32 @dense_weight.56(ptr nonnull %.4085, ptr nonnull %excinfo.30, ptr %arg.method, i64 %.3988.01163, double %.3777)
  switch i32 %.4089, label %B5260.if [
    i32 -2, label %B5260.endif
    i32 0, label %B5260.endif
  ]

B5260.if:
  %.4097 = icmp sgt i32 %.4089, 0
  %.4090 = load ptr, ptr %excinfo.30, align 8
  %.4098 = select i1 %.4097, ptr %.4090, ptr undef
  store ptr %.4098, ptr %excinfo, align 8
  br label %common.ret

B5260.endif:
  %.4099 = load double, ptr %.4085, align 8
  %.4116.idx = mul i64 %.4113, %.3988.01163
  %.4116 = getelementptr i8, ptr %.272, i64 %.4116.idx
  store ptr null, ptr %.4118, align 8
  %.4122 = call i32 @add_scaled.29(ptr nonnull %.4118, ptr nonnull %excinfo.31, i64 %.142, double %.4099, ptr %.4116, ptr %.287)
  switch i32 %.4122, label %B5260.endif.if [
    i32 -2, label %B5260.endif.endif
    i32 0, label %B5260.endif.endif
  ]

B5260.endif.if:
  %.4130 = icmp sgt i32 %.4122, 0
  %.4123 = load ptr, ptr %excinfo.31, align 8
  %.4131 = select i1 %.4130, ptr %.4123, ptr undef
  store ptr %.4131, ptr %excinfo, align 8
  br label %common.ret

B5260.endif.endif:
  %exitcond1405.not = icmp eq i64 %.4057, 8
  br i1 %exitcond1405.not, label %B5430.preheader, label %B5258.if

B5430.if:
  %.4171.01171 = phi i64 [ %.4240, %B5430.loopexit ], [ 0, %B5430.preheader ]
  %.4240 = add nuw nsw i64 %.4171.01171, 1
  %.4271.idx = shl i64 %.4171.01171, 4
  %.4271 = getelementptr i8, ptr %arg.ends_dot, i64 %.4271.idx
  store double 0.000000e+00, ptr %.4274, align 8
  %.4278 = call i32 @begin_rate.63(ptr nonnull %.4274, ptr nonnull %excinfo.32, i64 %.578.sroa.0.01183, ptr %.4271)
  %.4288 = load double, ptr %.4274, align 8
  switch i32 %.4278, label %B5432.if [
    i32 -2, label %B5432.endif
    i32 0, label %B5432.endif
  ]

B5432.if:
  %.4286 = icmp sgt i32 %.4278, 0
  %.4279 = load ptr, ptr %excinfo.32, align 8
  %.4287 = select i1 %.4286, ptr %.4279, ptr undef
  store ptr %.4287, ptr %excinfo, align 8
  br label %common.ret

B5432.endif:
  store double 0.000000e+00, ptr %.4301, align 8
  %.4305 = call i32 @size_rate.69(ptr nonnull %.4301, ptr nonnull %excinfo.33, i64 %.578.sroa.0.01183, i64 %arg.step_count, ptr %.4271)
  switch i32 %.4305, label %B5432.endif.if [
    i32 -2, label %B5432.endif.endif
    i32 0, label %B5432.endif.endif
  ]

B5432.endif.if:
  %.4313 = icmp sgt i32 %.4305, 0
  %.4306 = load ptr, ptr %excinfo.33, align 8
  %.4314 = select i1 %.4313, ptr %.4306, ptr undef
  store ptr %.4314, ptr %excinfo, align 8
  br label %common.ret

B5432.endif.endif:
  %.4315 = load double, ptr %.4301, align 8
  %.4326 = fmul contract double %.3777, %.4315
  %.4327 = fadd contract double %.4288, %.4326
  %.4328 = fneg contract double %.4327
  %.4333 = fdiv contract double %.4328, %.642
  %.4339 = mul nsw i64 %.4171.01171, %arg.edge_count
  %.4341 = add nsw i64 %.4339, %.3659.01174
  %.4343 = mul nsw i64 %.4341, %.112
  %.4345 = getelementptr double, ptr %arg.outputs, i64 %.4343
  %invariant.gep1165 = getelementptr double, ptr %.287, i64 %.4171.01171
  br i1 %.44291167.not, label %B5430.loopexit, label %B5634.if

B5634.if:
  %.4373.01168 = phi i64 [ %.4442, %B5634.if ], [ 0, %B5432.endif.endif ]
  %.4442 = add nuw nsw i64 %.4373.01168, 1
  %.idx914 = shl i64 %.4373.01168, 6
  %gep1166 = getelementptr i8, ptr %invariant.gep1165, i64 %.idx914
  %.4472 = load double, ptr %gep1166, align 8
  %.4474 = getelementptr double, ptr %.152, i64 %.4373.01168
  %.4475 = load double, ptr %.4474, align 8
  %.4477 = fmul contract double %.4333, %.4475
  %.4478 = fadd contract double %.4472, %.4477
  %.4480 = getelementptr double, ptr %.4345, i64 %.4373.01168
  store double %.4478, ptr %.4480, align 8
  %exitcond1406.not = icmp eq i64 %.112, %.4442
  br i1 %exitcond1406.not, label %B5430.loopexit, label %B5634.if

B5714.if:
  %.4532 = icmp sgt i32 %.4524, 0
  %.4525 = load ptr, ptr %excinfo.34, align 8
  %.4533 = select i1 %.4532, ptr %.4525, ptr undef
  store ptr %.4533, ptr %excinfo, align 8
  br label %common.ret

B5714.endif:
  %.588 = icmp sgt i64 %.534.11182, 0
  %.601 = zext i1 %.588 to i64
  %.531.1 = add i64 %.531.11181, %.601
  %.597 = sext i1 %.588 to i64
  %.534.1 = add nsw i64 %.534.11182, %.597
  %.578.sroa.0.0 = select i1 %.588, i64 %.531.11181, i64 0
  br i1 %.588, label %B1408, label %B5772
}

define internal i32 @moving_groups.62(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout) noinline {
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

define internal i32 @begin_rate.63(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.step, ptr noalias %arg.ends) noinline {
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

define internal i32 @size_rate.69(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.step, i64 %arg.count, ptr noalias %arg.ends) noinline {
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
  %.35 = call i32 @begin_rate.63(ptr nonnull %.31, ptr nonnull %excinfo.1, i64 %arg.step, ptr %arg.ends)
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

define internal i32 @multiply_sides.64(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.count, ptr noalias %arg.rows, ptr noalias %arg.columns, ptr noalias %arg.places, ptr noalias %arg.J, ptr noalias %arg.entries_dot, ptr noalias %arg.stage, ptr noalias %arg.place_dot, ptr noalias %arg.sides) noinline {
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

define internal i32 @add_scaled.71(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, double %arg.factor, ptr noalias %arg.x, ptr noalias %arg.y) {
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

define internal i32 @mark_moving.65(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.numbers_dot, ptr noalias %arg.moving) noinline {
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

define internal i32 @push_drive.66(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, i64 %arg.which, ptr noalias %arg.Y_dot, ptr noalias %arg.numbers_dot, ptr noalias %arg.rates_dot, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
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
  %.323 = call i32 @push.72(ptr nonnull %.319, ptr nonnull %excinfo.1, ptr %arg.layout, i64 %.167, i64 %arg.which, i64 %.213.0124, ptr %arg.derived, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.Y_dot, ptr %arg.numbers_dot, ptr %arg.local, ptr %arg.out)
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

define internal i32 @push_jacobian.67(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.pos, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.Y_dot, ptr noalias %arg.numbers_dot, ptr noalias %arg.J_dot, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
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
  %.514 = call i32 @push.72(ptr nonnull %.510, ptr nonnull %excinfo.2, ptr %arg.layout, i64 %2, i64 1, i64 %.405.0127, ptr %arg.derived, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.Y_dot, ptr %arg.numbers_dot, ptr %arg.local, ptr %arg.out)
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

define internal i32 @add_masses.68(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.mass, double %arg.factor, ptr noalias %arg.x, ptr noalias %arg.y) noinline {
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

define internal i32 @push_numbers.70(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.numbers_dot, ptr noalias %arg.moving, ptr noalias %arg.r_dot, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
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

define internal i32 @push.72(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, i64 %arg.table, i64 %arg.which, i64 %arg.group, ptr noalias %arg.derived, ptr noalias %arg.idx, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.Y_dot, ptr noalias %arg.numbers_dot, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
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
  %1 = call i32 @run_tape.73(ptr nonnull %r, ptr nonnull %e, i64 %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, i64 %a8, ptr %a9, ptr %a10)
  %v = load i64, ptr %r, align 8
  ret i64 %v
}

define internal i32 @run_tape.73(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.steps, ptr noalias %arg.code, ptr noalias %arg.constants, ptr noalias %arg.starts, ptr noalias %arg.strides, ptr noalias %arg.given, ptr noalias %arg.to, ptr noalias %arg.hops, i64 %arg.rows, ptr noalias %arg.room, ptr noalias %arg.found) noinline {
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
  %.75 = icmp slt i64 %arg.rows, 1
  br i1 %.75, label %B0.endif.endif, label %B0.endif.else

B48.loopexit:
  %.120 = icmp sgt i64 %.64.1405, 0
  %.133 = add i64 %.61.1404, 6
  %.61.1 = select i1 %.120, i64 %.133, i64 %.61.1404
  %.129 = sext i1 %.120 to i64
  %.64.1 = add nsw i64 %.64.1405, %.129
  %.110.sroa.0.0 = select i1 %.120, i64 %.61.1404, i64 0
  br i1 %.120, label %B52, label %B3004

B52:
  %.110.sroa.0.0406 = phi i64 [ 0, %B52.lr.ph ], [ %.110.sroa.0.0, %B48.loopexit ]
  %.64.1405 = phi i64 [ %.64.1403, %B52.lr.ph ], [ %.64.1, %B48.loopexit ]
  %.61.1404 = phi i64 [ 6, %B52.lr.ph ], [ %.61.1, %B48.loopexit ]
  %.163 = sub nsw i64 %arg.rows, %.110.sroa.0.0406
  store i64 0, ptr %.166, align 8
  %.172 = call i32 @numba.74(ptr nonnull %.166, ptr nonnull %excinfo.1, i64 6, i64 %.163)
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
  %.380 = call i32 @fill.75(ptr nonnull %.376, ptr nonnull %excinfo.2, i64 %.182, double %.371, ptr %.352)
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
  %.425 = mul nsw i64 %.423, %.110.sroa.0.0406
  %0 = getelementptr double, ptr %arg.given, i64 %.418
  %.428 = getelementptr double, ptr %0, i64 %.425
  store ptr null, ptr %.438, align 8
  %.442 = call i32 @pick.76(ptr nonnull %.438, ptr nonnull %excinfo.3, i64 %.182, ptr %.428, i64 %.423, ptr %.352)
  switch i32 %.442, label %B380.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B494:
  %.332 = getelementptr i8, ptr %.320, i64 12
  %.333 = load i32, ptr %.332, align 4
  %.466 = sext i32 %.327 to i64
  %.471.idx = mul nsw i64 %.466, 48
  %.471 = getelementptr i8, ptr %arg.room, i64 %.471.idx
  %.476 = sext i32 %.333 to i64
  %.479.idx = mul nsw i64 %.476, 48
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
  %.514 = mul nsw i64 %.500, %.110.sroa.0.0406
  %1 = getelementptr double, ptr %arg.found, i64 %.505
  %.517 = getelementptr double, ptr %1, i64 %.514
  store ptr null, ptr %.520, align 8
  %.524 = call i32 @put.77(ptr nonnull %.520, ptr nonnull %excinfo.4, i64 %.182, ptr %.471, i64 %.500, ptr %.517)
  switch i32 %.524, label %B612.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B750:
  store ptr null, ptr %.563, align 8
  %.567 = call i32 @each_same.78(ptr nonnull %.563, ptr nonnull %excinfo.5, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.567, label %B750.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B810:
  store ptr null, ptr %.605, align 8
  %.609 = call i32 @each_add.79(ptr nonnull %.605, ptr nonnull %excinfo.6, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.609, label %B810.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B872:
  store ptr null, ptr %.649, align 8
  %.653 = call i32 @each_sub.80(ptr nonnull %.649, ptr nonnull %excinfo.7, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.653, label %B872.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B934:
  store ptr null, ptr %.693, align 8
  %.697 = call i32 @each_mul.81(ptr nonnull %.693, ptr nonnull %excinfo.8, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.697, label %B934.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B996:
  store ptr null, ptr %.737, align 8
  %.741 = call i32 @each_div.82(ptr nonnull %.737, ptr nonnull %excinfo.9, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.741, label %B996.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1058:
  store ptr null, ptr %.782, align 8
  %.786 = call i32 @each_neg.83(ptr nonnull %.782, ptr nonnull %excinfo.10, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.786, label %B1058.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1118:
  store ptr null, ptr %.826, align 8
  %.830 = call i32 @each_mul.81(ptr nonnull %.826, ptr nonnull %excinfo.11, i64 %.182, ptr %.471, ptr %.471, ptr %.352)
  switch i32 %.830, label %B1118.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1180:
  store ptr null, ptr %.870, align 8
  %.874 = call i32 @each_add.79(ptr nonnull %.870, ptr nonnull %excinfo.12, i64 %.182, ptr %.471, ptr %.471, ptr %.352)
  switch i32 %.874, label %B1180.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1242:
  store ptr null, ptr %.913, align 8
  %.917 = call i32 @each_inv.84(ptr nonnull %.913, ptr nonnull %excinfo.13, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.917, label %B1242.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1302:
  store ptr null, ptr %.956, align 8
  %.960 = call i32 @each_sqrt.85(ptr nonnull %.956, ptr nonnull %excinfo.14, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.960, label %B1302.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1362:
  store ptr null, ptr %.999, align 8
  %.1003 = call i32 @each_fabs.86(ptr nonnull %.999, ptr nonnull %excinfo.15, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1003, label %B1362.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1422:
  store ptr null, ptr %.1042, align 8
  %.1046 = call i32 @each_exp.87(ptr nonnull %.1042, ptr nonnull %excinfo.16, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1046, label %B1422.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1482:
  store ptr null, ptr %.1085, align 8
  %.1089 = call i32 @each_log.88(ptr nonnull %.1085, ptr nonnull %excinfo.17, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1089, label %B1482.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1542:
  store ptr null, ptr %.1127, align 8
  %.1131 = call i32 @each_pow.89(ptr nonnull %.1127, ptr nonnull %excinfo.18, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1131, label %B1542.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1604:
  store ptr null, ptr %.1172, align 8
  %.1176 = call i32 @each_sin.90(ptr nonnull %.1172, ptr nonnull %excinfo.19, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1176, label %B1604.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1664:
  store ptr null, ptr %.1215, align 8
  %.1219 = call i32 @each_cos.91(ptr nonnull %.1215, ptr nonnull %excinfo.20, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1219, label %B1664.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1724:
  store ptr null, ptr %.1258, align 8
  %.1262 = call i32 @each_tan.92(ptr nonnull %.1258, ptr nonnull %excinfo.21, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1262, label %B1724.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1784:
  store ptr null, ptr %.1301, align 8
  %.1305 = call i32 @each_asin.93(ptr nonnull %.1301, ptr nonnull %excinfo.22, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1305, label %B1784.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1844:
  store ptr null, ptr %.1344, align 8
  %.1348 = call i32 @each_acos.94(ptr nonnull %.1344, ptr nonnull %excinfo.23, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1348, label %B1844.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1904:
  store ptr null, ptr %.1387, align 8
  %.1391 = call i32 @each_atan.95(ptr nonnull %.1387, ptr nonnull %excinfo.24, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1391, label %B1904.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B1964:
  store ptr null, ptr %.1429, align 8
  %.1433 = call i32 @each_atan_of_two.96(ptr nonnull %.1429, ptr nonnull %excinfo.25, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1433, label %B1964.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2026:
  store ptr null, ptr %.1474, align 8
  %.1478 = call i32 @each_sinh.97(ptr nonnull %.1474, ptr nonnull %excinfo.26, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1478, label %B2026.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2086:
  store ptr null, ptr %.1517, align 8
  %.1521 = call i32 @each_cosh.98(ptr nonnull %.1517, ptr nonnull %excinfo.27, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1521, label %B2086.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2146:
  store ptr null, ptr %.1560, align 8
  %.1564 = call i32 @each_tanh.99(ptr nonnull %.1560, ptr nonnull %excinfo.28, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1564, label %B2146.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2206:
  store ptr null, ptr %.1602, align 8
  %.1606 = call i32 @each_less.100(ptr nonnull %.1602, ptr nonnull %excinfo.29, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1606, label %B2206.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2268:
  store ptr null, ptr %.1646, align 8
  %.1650 = call i32 @each_less_or_equal.101(ptr nonnull %.1646, ptr nonnull %excinfo.30, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1650, label %B2268.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2330:
  store ptr null, ptr %.1690, align 8
  %.1694 = call i32 @each_equal.102(ptr nonnull %.1690, ptr nonnull %excinfo.31, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1694, label %B2330.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2392:
  store ptr null, ptr %.1734, align 8
  %.1738 = call i32 @each_unequal.103(ptr nonnull %.1734, ptr nonnull %excinfo.32, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1738, label %B2392.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2454:
  store ptr null, ptr %.1779, align 8
  %.1783 = call i32 @each_not.104(ptr nonnull %.1779, ptr nonnull %excinfo.33, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.1783, label %B2454.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2514:
  store ptr null, ptr %.1821, align 8
  %.1825 = call i32 @each_and.105(ptr nonnull %.1821, ptr nonnull %excinfo.34, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1825, label %B2514.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2576:
  store ptr null, ptr %.1865, align 8
  %.1869 = call i32 @each_or.106(ptr nonnull %.1865, ptr nonnull %excinfo.35, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1869, label %B2576.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2638:
  store ptr null, ptr %.1909, align 8
  %.1913 = call i32 @each_where.107(ptr nonnull %.1909, ptr nonnull %excinfo.36, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1913, label %B2638.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2700:
  store ptr null, ptr %.1953, align 8
  %.1957 = call i32 @each_smaller.108(ptr nonnull %.1953, ptr nonnull %excinfo.37, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.1957, label %B2700.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2762:
  store ptr null, ptr %.1997, align 8
  %.2001 = call i32 @each_larger.109(ptr nonnull %.1997, ptr nonnull %excinfo.38, i64 %.182, ptr %.471, ptr %.479, ptr %.352)
  switch i32 %.2001, label %B2762.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2824:
  store ptr null, ptr %.2042, align 8
  %.2046 = call i32 @each_sign.110(ptr nonnull %.2042, ptr nonnull %excinfo.39, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.2046, label %B2824.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2884:
  store ptr null, ptr %.2083, align 8
  %.2087 = call i32 @each_log_of_more.111(ptr nonnull %.2083, ptr nonnull %excinfo.40, i64 %.182, ptr %.471, ptr %.352)
  switch i32 %.2087, label %B2884.if [
    i32 -2, label %B3005
    i32 0, label %B3005
  ]

B2944:
  store ptr null, ptr %.2124, align 8
  %.2128 = call i32 @each_exp_less_one.112(ptr nonnull %.2124, ptr nonnull %excinfo.41, i64 %.182, ptr %.471, ptr %.352)
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

B0.endif.else:
  %.92 = urem i64 %arg.rows, 6
  %.95.not = icmp ne i64 %.92, 0
  %.96 = udiv i64 %arg.rows, 6
  %.97 = zext i1 %.95.not to i64
  %.98 = add nuw nsw i64 %.96, %.97
  br label %B0.endif.endif

B0.endif.endif:
  %storemerge = phi i64 [ %.98, %B0.endif.else ], [ 0, %entry ]
  %.120400 = icmp sgt i64 %storemerge, 0
  br i1 %.120400, label %B52.lr.ph, label %B3004

B52.lr.ph:
  %.64.1403 = add nsw i64 %storemerge, -1
  %.276397.not = icmp slt i64 %arg.steps, 1
  br label %B52

B52.if:
  %.180 = icmp sgt i32 %.172, 0
  %.173 = load ptr, ptr %excinfo.1, align 8
  %.181 = select i1 %.180, ptr %.173, ptr undef
  store ptr %.181, ptr %excinfo, align 8
  br label %common.ret

B52.endif:
  br i1 %.276397.not, label %B48.loopexit, label %B134.if

B134.if:
  %.219.0398 = phi i64 [ %.289, %B3005 ], [ 0, %B52.endif ]
  %.289 = add nuw nsw i64 %.219.0398, 1
  %.320.idx = shl i64 %.219.0398, 4
  %.320 = getelementptr i8, ptr %arg.code, i64 %.320.idx
  %.321 = load i32, ptr %.320, align 4
  %.326 = getelementptr i8, ptr %.320, i64 8
  %.327 = load i32, ptr %.326, align 4
  %.347 = getelementptr i8, ptr %.320, i64 4
  %.348 = load i32, ptr %.347, align 4
  %.349 = sext i32 %.348 to i64
  %.352.idx = mul nsw i64 %.349, 48
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

define internal i32 @numba.74(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.x.0, i64 %arg.x.1) {
entry:
  %.11 = call i64 @llvm.smin.i64(i64 %arg.x.1, i64 %arg.x.0)
  store i64 %.11, ptr %retptr, align 8
  ret i32 0
}

define internal i32 @fill.75(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, double %arg.value, ptr noalias %arg.z) noinline {
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

define internal i32 @pick.76(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, i64 %arg.stride, ptr noalias %arg.z) noinline {
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

define internal i32 @put.77(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, i64 %arg.hop, ptr noalias %arg.z) noinline {
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

define internal i32 @each_same.78(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_add.79(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
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

define internal i32 @each_sub.80(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
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

define internal i32 @each_mul.81(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
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

define internal i32 @each_div.82(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
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

define internal i32 @each_neg.83(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_inv.84(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_sqrt.85(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_fabs.86(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_exp.87(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_log.88(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_pow.89(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
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

define internal i32 @each_sin.90(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_cos.91(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_tan.92(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_asin.93(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_acos.94(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_atan.95(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_atan_of_two.96(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
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

define internal i32 @each_sinh.97(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_cosh.98(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_tanh.99(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_less.100(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
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

define internal i32 @each_less_or_equal.101(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
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

define internal i32 @each_equal.102(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
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

define internal i32 @each_unequal.103(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
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

define internal i32 @each_not.104(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_and.105(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
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

define internal i32 @each_or.106(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
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

define internal i32 @each_where.107(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
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

define internal i32 @each_smaller.108(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
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

define internal i32 @each_larger.109(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y, ptr noalias %arg.z) noinline {
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

define internal i32 @each_sign.110(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_log_of_more.111(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define internal i32 @each_exp_less_one.112(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.z) noinline {
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

define i64 @sines_and_cosines(i64 %a0, ptr %a1, ptr %a2, ptr %a3) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @sines_and_cosines.113(ptr nonnull %r, ptr nonnull %e, i64 %a0, ptr %a1, ptr %a2, ptr %a3)
  ret i64 0
}

define internal i32 @sines_and_cosines.113(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.count, ptr noalias %arg.angle, ptr noalias %arg.sine, ptr noalias %arg.cosine) noinline {
entry:
  %.137 = alloca [2 x double], align 8
  %.fca.1.gep = getelementptr inbounds nuw i8, ptr %.137, i64 8
  %excinfo.1 = alloca ptr, align 8
  call void @llvm.memset.p0.i64(ptr nonnull align 8 dereferenceable(16) %.137, i8 0, i64 16, i1 false)
  store ptr null, ptr %excinfo.1, align 8
  %.9553.not = icmp slt i64 %arg.count, 1
  br i1 %.9553.not, label %B100, label %B34.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B100 ], [ %.141, %B36.if ]
  ret i32 %common.ret.op

B100:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B34.if:
  %.37.054 = phi i64 [ %.108, %B36.endif ], [ 0, %entry ]
  %.135 = getelementptr double, ptr %arg.angle, i64 %.37.054
  %.136 = load double, ptr %.135, align 8
  call void @llvm.memset.p0.i64(ptr nonnull align 8 dereferenceable(16) %.137, i8 0, i64 16, i1 false)
  %.141 = call i32 @sine_and_cosine.114(ptr nonnull %.137, ptr nonnull %excinfo.1, double %.136)
  switch i32 %.141, label %B36.if [
    i32 -2, label %B36.endif
    i32 0, label %B36.endif
  ]

B36.if:
  %.149 = icmp sgt i32 %.141, 0
  %.142 = load ptr, ptr %excinfo.1, align 8
  %.150 = select i1 %.149, ptr %.142, ptr undef
  store ptr %.150, ptr %excinfo, align 8
  br label %common.ret

B36.endif:
  %.108 = add nuw nsw i64 %.37.054, 1
  %.151.fca.1.load = load double, ptr %.fca.1.gep, align 8
  %.151.fca.0.load = load double, ptr %.137, align 8
  %.164 = getelementptr double, ptr %arg.sine, i64 %.37.054
  store double %.151.fca.0.load, ptr %.164, align 8
  %.167 = getelementptr double, ptr %arg.cosine, i64 %.37.054
  store double %.151.fca.1.load, ptr %.167, align 8
  %exitcond.not = icmp eq i64 %arg.count, %.108
  br i1 %exitcond.not, label %B100, label %B34.if
}

define internal i32 @sine_and_cosine.114(ptr noalias %retptr, ptr noalias %excinfo, double %arg.angle) {
entry:
  %.5 = fmul contract double %arg.angle, 0x3FE45F306DC9C883
  %.6 = fadd contract double %.5, 0x4338000000000000
  %.7 = fadd contract double %.6, 0xC338000000000000
  %.8 = fmul contract double %.7, 0x3FF921FB54400000
  %.9 = fsub contract double %arg.angle, %.8
  %.10 = fmul contract double %.7, 0x3DD0B4611A600000
  %.11 = fsub contract double %.9, %.10
  %.12 = fmul contract double %.7, 0x3BA3198A2E037073
  %.13 = fsub contract double %.11, %.12
  %.18 = fmul contract double %.7, 2.500000e-01
  %.19 = fadd contract double %.18, 0x4338000000000000
  %.20 = fadd contract double %.19, 0xC338000000000000
  %.22 = fmul contract double %.20, 4.000000e+00
  %.23 = fsub contract double %.7, %.22
  %.27 = fmul contract double %.13, %.13
  %.28 = fmul contract double %.27, 0x3DE5D93A5ACFD57C
  %.29 = fadd contract double %.28, 0xBE5AE5E68A2B9CEB
  %.30 = fmul contract double %.27, %.29
  %.31 = fadd contract double %.30, 0x3EC71DE357B1FE7D
  %.32 = fmul contract double %.27, %.31
  %.33 = fadd contract double %.32, 0xBF2A01A019C161D5
  %.34 = fmul contract double %.27, %.33
  %.35 = fadd contract double %.34, 0x3F8111111110F8A6
  %.36 = fmul contract double %.27, %.35
  %.37 = fadd contract double %.36, 0xBFC5555555555549
  %.38 = fmul contract double %.13, %.27
  %.39 = fmul contract double %.38, %.37
  %.40 = fadd contract double %.13, %.39
  %.44 = fmul contract double %.27, 0x3DA8FAE9BE8838D4
  %.45 = fsub contract double 0x3E21EE9EBDB4B1C4, %.44
  %.46 = fmul contract double %.27, %.45
  %.47 = fadd contract double %.46, 0xBE927E4F809C52AD
  %.48 = fmul contract double %.27, %.47
  %.49 = fadd contract double %.48, 0x3EFA01A019CB1590
  %.50 = fmul contract double %.27, %.49
  %.51 = fadd contract double %.50, 0xBF56C16C16C15177
  %.52 = fmul contract double %.27, %.51
  %.53 = fadd contract double %.52, 0x3FA555555555554C
  %.58 = fmul contract double %.27, 5.000000e-01
  %.59 = fmul contract double %.27, %.27
  %.60 = fmul contract double %.59, %.53
  %0 = fsub contract double %.60, %.58
  %.63 = fadd contract double %0, 1.000000e+00
  %.69 = fmul contract double %.23, %.23
  %.70 = fcmp contract oeq double %.69, 1.000000e+00
  %.63..40 = select i1 %.70, double %.63, double %.40
  %"$phi428.1.2.0" = select i1 %.70, double %.40, double %.63
  %.119 = fadd contract double %.23, -5.000000e-01
  %.120 = call contract double @llvm.fabs.f64(double %.119)
  %.121 = fcmp contract olt double %.120, 1.000000e+00
  %.131 = fneg contract double %.63..40
  %"$phi484.0.2.0" = select i1 %.121, double %.63..40, double %.131
  %.144 = fadd contract double %.23, 5.000000e-01
  %.147 = call contract double @llvm.fabs.f64(double %.144)
  %.148 = fcmp contract olt double %.147, 1.000000e+00
  %.158 = fneg contract double %"$phi428.1.2.0"
  %"$phi538.0.2.0" = select i1 %.148, double %"$phi428.1.2.0", double %.158
  store double %"$phi484.0.2.0", ptr %retptr, align 8
  %retptr.repack1 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store double %"$phi538.0.2.0", ptr %retptr.repack1, align 8
  ret i32 0
}

define i64 @lay_axes(i64 %a0, i64 %a1, i64 %a2, double %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @lay_axes.115(ptr nonnull %r, ptr nonnull %e, i64 %a0, i64 %a1, i64 %a2, double %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9)
  ret i64 0
}

define internal i32 @lay_axes.115(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.rows, i64 %arg.pieces, i64 %arg.samples, double %arg.length, ptr noalias %arg.curvature, ptr noalias %arg.stretch, ptr noalias %arg.room, ptr noalias %arg.nodes, ptr noalias %arg.middle, ptr noalias %arg.direction) noinline {
entry:
  %.578 = alloca [2 x double], align 8
  %.fca.1.gep4 = getelementptr inbounds nuw i8, ptr %.578, i64 8
  %excinfo.1 = alloca ptr, align 8
  call void @llvm.memset.p0.i64(ptr nonnull align 8 dereferenceable(16) %.578, i8 0, i64 16, i1 false)
  store ptr null, ptr %excinfo.1, align 8
  %.612 = alloca [2 x double], align 8
  %excinfo.2 = alloca ptr, align 8
  call void @llvm.memset.p0.i64(ptr nonnull align 8 dereferenceable(16) %.612, i8 0, i64 16, i1 false)
  store ptr null, ptr %excinfo.2, align 8
  %.34 = mul nsw i64 %arg.samples, %arg.pieces
  %.120260.not = icmp slt i64 %arg.rows, 1
  br i1 %.120260.not, label %B720, label %B46.if.lr.ph

B46.if.lr.ph:
  %0 = call i64 @llvm.smax.i64(i64 %arg.samples, i64 0)
  %storemerge247 = mul i64 %0, 3
  %.242251.not = icmp slt i64 %arg.samples, 1
  %.369257.not = icmp slt i64 %arg.pieces, 1
  %.491254.not = icmp slt i64 %arg.samples, 1
  %.566 = fmul contract double %arg.length, 5.000000e-01
  %1 = getelementptr double, ptr %arg.room, i64 %arg.samples
  %.idx = shl i64 %arg.samples, 4
  %2 = getelementptr i8, ptr %arg.room, i64 %.idx
  %3 = call i64 @llvm.smax.i64(i64 %storemerge247, i64 1)
  %4 = shl nuw i64 %3, 3
  br label %B46.if

B44.loopexit:
  %exitcond267.not = icmp eq i64 %.133, %arg.rows
  br i1 %exitcond267.not, label %B720, label %B46.if

B102:
  br i1 %.369257.not, label %B44.loopexit, label %B134.if.lr.ph

B134.if.lr.ph:
  %.538 = shl nuw nsw i64 %.61.0261, 1
  %.540 = mul nsw i64 %.538, %.34
  %.544 = or disjoint i64 %.538, 1
  %.546 = mul nsw i64 %.544, %.34
  %.556 = mul nsw i64 %.61.0261, %.34
  br label %B134.if

B132.loopexit:
  %exitcond266.not = icmp eq i64 %arg.pieces, %.382
  br i1 %exitcond266.not, label %B44.loopexit, label %B134.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B720 ], [ %.616, %B172.endif.endif.if ], [ %.582, %B172.endif.if ]
  ret i32 %common.ret.op

B720:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B46.if:
  %.61.0261 = phi i64 [ 0, %B46.if.lr.ph ], [ %.133, %B44.loopexit ]
  %.133 = add nuw nsw i64 %.61.0261, 1
  br i1 %.242251.not, label %B102, label %B86.if.preheader

B86.if.preheader:
  call void @llvm.memset.p0.i64(ptr nonnull align 8 dereferenceable(1) %arg.room, i8 0, i64 %4, i1 false)
  br label %B102

B134.if:
  %.312.0258 = phi i64 [ 0, %B134.if.lr.ph ], [ %.382, %B132.loopexit ]
  %.382 = add nuw nsw i64 %.312.0258, 1
  %5 = mul nsw i64 %.312.0258, %arg.samples
  br i1 %.491254.not, label %B132.loopexit, label %B170.if

B170.if:
  %.434.0255 = phi i64 [ %.504, %B172.endif.endif.endif ], [ 0, %B134.if ]
  %.504 = add nuw nsw i64 %.434.0255, 1
  %.536 = add nuw nsw i64 %.434.0255, %5
  %.541 = add nuw nsw i64 %.536, %.540
  %.547 = add nuw nsw i64 %.536, %.546
  %.557 = add nuw nsw i64 %.536, %.556
  %.559 = getelementptr double, ptr %arg.curvature, i64 %.557
  %.560 = load double, ptr %.559, align 8
  %.567 = fmul contract double %.566, %.560
  %.574 = getelementptr double, ptr %arg.room, i64 %.434.0255
  %.575 = load double, ptr %.574, align 8
  %.577 = fadd contract double %.575, %.567
  call void @llvm.memset.p0.i64(ptr nonnull align 8 dereferenceable(16) %.578, i8 0, i64 16, i1 false)
  %.582 = call i32 @sine_and_cosine.114(ptr nonnull %.578, ptr nonnull %excinfo.1, double %.577)
  %.592.fca.0.load = load double, ptr %.578, align 8
  %.592.fca.1.load = load double, ptr %.fca.1.gep4, align 8
  switch i32 %.582, label %B172.endif.if [
    i32 -2, label %B172.endif.endif
    i32 0, label %B172.endif.endif
  ]

B172.endif.if:
  %.590 = icmp sgt i32 %.582, 0
  %.583 = load ptr, ptr %excinfo.1, align 8
  %.591 = select i1 %.590, ptr %.583, ptr undef
  store ptr %.591, ptr %excinfo, align 8
  br label %common.ret

B172.endif.endif:
  call void @llvm.memset.p0.i64(ptr nonnull align 8 dereferenceable(16) %.612, i8 0, i64 16, i1 false)
  %.616 = call i32 @sine_and_cosine.114(ptr nonnull %.612, ptr nonnull %excinfo.2, double %.567)
  switch i32 %.616, label %B172.endif.endif.if [
    i32 -2, label %B172.endif.endif.endif
    i32 0, label %B172.endif.endif.endif
  ]

B172.endif.endif.if:
  %.624 = icmp sgt i32 %.616, 0
  %.617 = load ptr, ptr %excinfo.2, align 8
  %.625 = select i1 %.624, ptr %.617, ptr undef
  store ptr %.625, ptr %excinfo, align 8
  br label %common.ret

B172.endif.endif.endif:
  %.626.fca.0.load = load double, ptr %.612, align 8
  %.646 = getelementptr double, ptr %arg.stretch, i64 %.557
  %.647 = load double, ptr %.646, align 8
  %.649 = fmul contract double %arg.length, %.647
  %.651 = fcmp contract une double %.567, 0.000000e+00
  %.661 = fdiv contract double %.626.fca.0.load, %.567
  %"$phi426.4.2.3" = select i1 %.651, double %.661, double 1.000000e+00
  %.675 = fmul contract double %.649, %"$phi426.4.2.3"
  %.684 = getelementptr double, ptr %1, i64 %.434.0255
  %.685 = load double, ptr %.684, align 8
  %.691 = getelementptr double, ptr %2, i64 %.434.0255
  %.692 = load double, ptr %.691, align 8
  %.699 = fmul contract double %.567, 2.000000e+00
  %.702 = fadd contract double %.575, %.699
  store double %.702, ptr %.574, align 8
  %.708 = fmul contract double %.592.fca.0.load, %.675
  %.709 = fadd contract double %.685, %.708
  store double %.709, ptr %.684, align 8
  %.717 = fmul contract double %.592.fca.1.load, %.675
  %.718 = fadd contract double %.692, %.717
  store double %.718, ptr %.691, align 8
  %.736 = getelementptr double, ptr %arg.nodes, i64 %.541
  store double %.709, ptr %.736, align 8
  %.740 = getelementptr double, ptr %arg.nodes, i64 %.547
  store double %.718, ptr %.740, align 8
  %.746 = fmul contract double %.675, 5.000000e-01
  %.748 = fmul contract double %.592.fca.0.load, %.746
  %.749 = fadd contract double %.685, %.748
  %.756 = fmul contract double %.592.fca.1.load, %.746
  %.757 = fadd contract double %.692, %.756
  %.760 = getelementptr double, ptr %arg.middle, i64 %.541
  store double %.749, ptr %.760, align 8
  %.764 = getelementptr double, ptr %arg.middle, i64 %.547
  store double %.757, ptr %.764, align 8
  %.769 = getelementptr double, ptr %arg.direction, i64 %.541
  store double %.592.fca.0.load, ptr %.769, align 8
  %.778 = getelementptr double, ptr %arg.direction, i64 %.547
  store double %.592.fca.1.load, ptr %.778, align 8
  %exitcond.not = icmp eq i64 %arg.samples, %.504
  br i1 %exitcond.not, label %B132.loopexit, label %B170.if
}

define i64 @strain_axes(i64 %a0, i64 %a1, i64 %a2, double %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @strain_axes.116(ptr nonnull %r, ptr nonnull %e, i64 %a0, i64 %a1, i64 %a2, double %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12)
  ret i64 0
}

define internal i32 @strain_axes.116(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.rows, i64 %arg.pieces, i64 %arg.samples, double %arg.most, ptr noalias %arg.turns, ptr noalias %arg.draws, ptr noalias %arg.nodes, ptr noalias %arg.middle, ptr noalias %arg.direction, ptr noalias %arg.force, ptr noalias %arg.room, ptr noalias %arg.turned, ptr noalias %arg.drawn) noinline {
entry:
  %.43 = mul nsw i64 %arg.samples, %arg.pieces
  %.129191.not = icmp slt i64 %arg.rows, 1
  br i1 %.129191.not, label %B710, label %B46.if.lr.ph

B46.if.lr.ph:
  %0 = call i64 @llvm.smax.i64(i64 %arg.samples, i64 0)
  %storemerge179 = mul i64 %0, 3
  %.251182.not = icmp slt i64 %arg.samples, 1
  %.378188.not = icmp slt i64 %arg.pieces, 1
  %.503185.not = icmp slt i64 %arg.samples, 1
  %1 = getelementptr double, ptr %arg.room, i64 %arg.samples
  %.idx = shl i64 %arg.samples, 4
  %2 = getelementptr i8, ptr %arg.room, i64 %.idx
  %.679 = fneg contract double %arg.most
  %3 = call i64 @llvm.smax.i64(i64 %storemerge179, i64 1)
  %4 = shl nuw i64 %3, 3
  br label %B46.if

B44.loopexit:
  %exitcond195.not = icmp eq i64 %.142, %arg.rows
  br i1 %exitcond195.not, label %B710, label %B46.if

B102:
  br i1 %.378188.not, label %B44.loopexit, label %B134.if.lr.ph

B134.if.lr.ph:
  %.549 = shl nuw nsw i64 %.70.0192, 1
  %.551 = mul nsw i64 %.549, %.43
  %.556 = or disjoint i64 %.549, 1
  %.558 = mul nsw i64 %.556, %.43
  %.699 = mul nsw i64 %.70.0192, %.43
  br label %B134.if

B132.loopexit:
  %exitcond194.not = icmp eq i64 %arg.pieces, %.391
  br i1 %exitcond194.not, label %B44.loopexit, label %B134.if

B710:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B46.if:
  %.70.0192 = phi i64 [ 0, %B46.if.lr.ph ], [ %.142, %B44.loopexit ]
  %.142 = add nuw nsw i64 %.70.0192, 1
  br i1 %.251182.not, label %B102, label %B86.if.preheader

B86.if.preheader:
  call void @llvm.memset.p0.i64(ptr nonnull align 8 dereferenceable(1) %arg.room, i8 0, i64 %4, i1 false)
  br label %B102

B134.if:
  %.321.0189 = phi i64 [ 0, %B134.if.lr.ph ], [ %.391, %B132.loopexit ]
  %.391 = add nuw nsw i64 %.321.0189, 1
  br i1 %.503185.not, label %B132.loopexit, label %B186.if.lr.ph

B186.if.lr.ph:
  %5 = xor i64 %.321.0189, -1
  %.418 = add nsw i64 %arg.pieces, %5
  %.543 = mul nsw i64 %.418, %arg.samples
  %.635 = getelementptr double, ptr %arg.turns, i64 %.418
  %.636 = load double, ptr %.635, align 8
  %.731 = getelementptr double, ptr %arg.draws, i64 %.418
  %.732 = load double, ptr %.731, align 8
  br label %B186.if

B186.if:
  %.446.0186 = phi i64 [ 0, %B186.if.lr.ph ], [ %.516, %B186.if ]
  %.516 = add nuw nsw i64 %.446.0186, 1
  %.544 = add nsw i64 %.446.0186, %.543
  %.553 = add nsw i64 %.544, %.551
  %.560 = add nsw i64 %.544, %.558
  %.568 = getelementptr double, ptr %arg.room, i64 %.446.0186
  %.569 = load double, ptr %.568, align 8
  %.572 = getelementptr double, ptr %arg.force, i64 %.553
  %.573 = load double, ptr %.572, align 8
  %.574 = fadd contract double %.569, %.573
  %.578 = getelementptr double, ptr %1, i64 %.446.0186
  %.579 = load double, ptr %.578, align 8
  %.582 = getelementptr double, ptr %arg.force, i64 %.560
  %.583 = load double, ptr %.582, align 8
  %.584 = fadd contract double %.579, %.583
  %.595 = getelementptr double, ptr %2, i64 %.446.0186
  %.596 = load double, ptr %.595, align 8
  %.599 = getelementptr double, ptr %arg.nodes, i64 %.553
  %.600 = load double, ptr %.599, align 8
  %.605 = fmul contract double %.583, %.600
  %.608 = getelementptr double, ptr %arg.nodes, i64 %.560
  %.609 = load double, ptr %.608, align 8
  %.614 = fmul contract double %.573, %.609
  %.615 = fsub contract double %.605, %.614
  %.616 = fadd contract double %.596, %.615
  store double %.574, ptr %.568, align 8
  store double %.584, ptr %.578, align 8
  store double %.616, ptr %.595, align 8
  %.639 = getelementptr double, ptr %arg.middle, i64 %.553
  %.640 = load double, ptr %.639, align 8
  %.642 = fmul contract double %.584, %.640
  %.645 = getelementptr double, ptr %arg.middle, i64 %.560
  %.646 = load double, ptr %.645, align 8
  %.648 = fmul contract double %.574, %.646
  %.649 = fsub contract double %.642, %.648
  %.650 = fsub contract double %.649, %.616
  %.651 = fmul contract double %.636, %.650
  %.657 = fcmp contract ogt double %.651, %arg.most
  %arg.most..651 = select i1 %.657, double %arg.most, double %.651
  %.681 = fcmp contract olt double %arg.most..651, %.679
  %"$phi592.3.2.3" = select i1 %.681, double %.679, double %arg.most..651
  %.701 = add nsw i64 %.544, %.699
  %.704 = getelementptr double, ptr %arg.turned, i64 %.701
  store double %"$phi592.3.2.3", ptr %.704, align 8
  %.710 = getelementptr double, ptr %arg.direction, i64 %.553
  %.711 = load double, ptr %.710, align 8
  %.715 = fmul contract double %.574, %.711
  %.720 = getelementptr double, ptr %arg.direction, i64 %.560
  %.721 = load double, ptr %.720, align 8
  %.725 = fmul contract double %.584, %.721
  %.728 = fadd contract double %.715, %.725
  %.733 = fmul contract double %.732, %.728
  %.742 = getelementptr double, ptr %arg.drawn, i64 %.701
  store double %.733, ptr %.742, align 8
  %exitcond.not = icmp eq i64 %arg.samples, %.516
  br i1 %exitcond.not, label %B132.loopexit, label %B186.if
}

define i64 @follow(i64 %a0, i64 %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @follow.117(ptr nonnull %r, ptr nonnull %e, i64 %a0, i64 %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8)
  ret i64 0
}

define internal i32 @follow.117(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.steps, i64 %arg.count, i64 %arg.channels, ptr noalias %arg.step, ptr noalias %arg.rate, ptr noalias %arg.drive, ptr noalias %arg.state, ptr noalias %arg.room, ptr noalias %arg.found) noinline {
entry:
  %.296 = alloca double, align 8
  store double 0.000000e+00, ptr %.296, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.120183.not = icmp slt i64 %arg.count, 1
  br i1 %.120183.not, label %B802, label %B50.if.lr.ph

B50.if.lr.ph:
  %.30 = shl nsw i64 %arg.steps, 1
  %.241173.not = icmp slt i64 %arg.steps, 1
  %0 = getelementptr double, ptr %arg.room, i64 %arg.steps
  %1 = getelementptr double, ptr %arg.room, i64 %.30
  %storemerge171 = call i64 @llvm.smax.i64(i64 %arg.channels, i64 0)
  %.572180.not = icmp slt i64 %arg.channels, 1
  %.614 = add nsw i64 %arg.steps, 1
  %.711176.not = icmp slt i64 %arg.steps, 1
  %2 = getelementptr double, ptr %arg.room, i64 %arg.steps
  %3 = getelementptr double, ptr %arg.room, i64 %.30
  br label %B50.if

B48.loopexit:
  %exitcond188.not = icmp eq i64 %.133, %arg.count
  br i1 %exitcond188.not, label %B802, label %B50.if

B494:
  br i1 %.572180.not, label %B48.loopexit, label %B544.if.preheader

B544.if.preheader:
  %.486 = mul nuw nsw i64 %.61.0184, %arg.channels
  br label %B544.if

B786:
  %value.2.2.lcssa = phi double [ %.620, %B544.if ], [ %.779, %B620.if ]
  store double %value.2.2.lcssa, ptr %.619, align 8
  %.572 = icmp sgt i64 %.519.0182, 1
  br i1 %.572, label %B544.if, label %B48.loopexit

common.ret:
  %common.ret.op = phi i32 [ 0, %B802 ], [ %.300, %B86.if ]
  ret i32 %common.ret.op

B802:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B50.if:
  %.61.0184 = phi i64 [ 0, %B50.if.lr.ph ], [ %.133, %B48.loopexit ]
  %.133 = add nuw nsw i64 %.61.0184, 1
  br i1 %.241173.not, label %B494, label %B84.if.lr.ph

B84.if.lr.ph:
  %.288 = getelementptr double, ptr %arg.rate, i64 %.61.0184
  %.289 = load double, ptr %.288, align 8
  br label %B84.if

B84.if:
  %.185.0174 = phi i64 [ 0, %B84.if.lr.ph ], [ %.254, %B86.endif ]
  %.284 = getelementptr double, ptr %arg.step, i64 %.185.0174
  %.285 = load double, ptr %.284, align 8
  %.290 = fmul contract double %.285, %.289
  store double 0.000000e+00, ptr %.296, align 8
  %.300 = call i32 @exponential.118(ptr nonnull %.296, ptr nonnull %excinfo.1, double %.290)
  switch i32 %.300, label %B86.if [
    i32 -2, label %B86.endif
    i32 0, label %B86.endif
  ]

B86.if:
  %.308 = icmp sgt i32 %.300, 0
  %.301 = load ptr, ptr %excinfo.1, align 8
  %.309 = select i1 %.308, ptr %.301, ptr undef
  store ptr %.309, ptr %excinfo, align 8
  br label %common.ret

B86.endif:
  %.310 = load double, ptr %.296, align 8
  %.254 = add nuw nsw i64 %.185.0174, 1
  %.324 = fmul contract double %.290, 2.000000e-01
  %.326 = fmul contract double %.290, 0x3FC5555555555555
  %.328 = fmul contract double %.290, 0x3FC2492492492492
  %.330 = fadd contract double %.328, 1.000000e+00
  %.331 = fmul contract double %.326, %.330
  %.333 = fadd contract double %.331, 1.000000e+00
  %.334 = fmul contract double %.324, %.333
  %.336 = fadd contract double %.334, 1.000000e+00
  %.338 = fmul contract double %.290, 0x3FD5555555555555
  %.344 = fmul contract double %.290, 2.500000e-01
  %.345 = fmul contract double %.344, %.336
  %.347 = fadd contract double %.345, 1.000000e+00
  %.348 = fmul contract double %.338, %.347
  %.350 = fadd contract double %.348, 1.000000e+00
  %.356 = fadd contract double %.310, -1.000000e+00
  %.361 = fdiv contract double %.356, %.290
  %.367 = fadd contract double %.361, -1.000000e+00
  %.372 = fdiv contract double %.367, %.290
  %.377 = call contract double @llvm.fabs.f64(double %.290)
  %.378 = fcmp contract olt double %.377, 1.000000e-02
  %.391 = fmul contract double %.290, 5.000000e-01
  %.395 = fmul contract double %.391, %.350
  %.397 = fadd contract double %.395, 1.000000e+00
  %"$phi392.2.2.2" = select i1 %.378, double %.397, double %.361
  %.427 = fmul contract double %.350, 5.000000e-01
  %"$phi410.2.2.2" = select i1 %.378, double %.427, double %.372
  %.450 = fmul contract double %.285, %"$phi392.2.2.2"
  %.457 = fmul contract double %.285, %"$phi410.2.2.2"
  %.461 = getelementptr double, ptr %arg.room, i64 %.185.0174
  store double %.310, ptr %.461, align 8
  %.469 = getelementptr double, ptr %0, i64 %.185.0174
  store double %.450, ptr %.469, align 8
  %.477 = getelementptr double, ptr %1, i64 %.185.0174
  store double %.457, ptr %.477, align 8
  %exitcond.not = icmp eq i64 %arg.steps, %.254
  br i1 %exitcond.not, label %B494, label %B84.if

B544.if:
  %.519.0182 = phi i64 [ %.581, %B786 ], [ %storemerge171, %B544.if.preheader ]
  %.516.0181 = phi i64 [ %.585, %B786 ], [ %.486, %B544.if.preheader ]
  %.581 = add nsw i64 %.519.0182, -1
  %.585 = add i64 %.516.0181, 1
  %.616 = mul nsw i64 %.516.0181, %.614
  %.619 = getelementptr double, ptr %arg.state, i64 %.516.0181
  %.620 = load double, ptr %.619, align 8
  %.629 = getelementptr double, ptr %arg.found, i64 %.616
  store double %.620, ptr %.629, align 8
  br i1 %.711176.not, label %B786, label %B620.if

B620.if:
  %value.2.2179 = phi double [ %.779, %B620.if ], [ %.620, %B544.if ]
  %.655.0177 = phi i64 [ %.724, %B620.if ], [ 0, %B544.if ]
  %.724 = add nuw nsw i64 %.655.0177, 1
  %.750 = add nsw i64 %.655.0177, %.616
  %.752 = getelementptr double, ptr %arg.drive, i64 %.750
  %.753 = load double, ptr %.752, align 8
  %.757 = getelementptr double, ptr %2, i64 %.655.0177
  %.758 = load double, ptr %.757, align 8
  %.759 = fmul contract double %.753, %.758
  %.763 = getelementptr double, ptr %3, i64 %.655.0177
  %.764 = load double, ptr %.763, align 8
  %.767 = add nsw i64 %.750, 1
  %.769 = getelementptr double, ptr %arg.drive, i64 %.767
  %.770 = load double, ptr %.769, align 8
  %.771 = fsub contract double %.770, %.753
  %.772 = fmul contract double %.764, %.771
  %.773 = fadd contract double %.759, %.772
  %.775 = getelementptr double, ptr %arg.room, i64 %.655.0177
  %.776 = load double, ptr %.775, align 8
  %.778 = fmul contract double %value.2.2179, %.776
  %.779 = fadd contract double %.778, %.773
  %.786 = getelementptr double, ptr %arg.found, i64 %.767
  store double %.779, ptr %.786, align 8
  %exitcond187.not = icmp eq i64 %arg.steps, %.724
  br i1 %exitcond187.not, label %B786, label %B620.if
}

define internal i32 @exponential.118(ptr noalias %retptr, ptr noalias %excinfo, double %arg.x) {
entry:
  %.8 = fcmp contract ogt double %arg.x, -7.080000e+02
  %arg.x. = select i1 %.8, double %arg.x, double -7.080000e+02
  %.29 = fcmp contract olt double %arg.x., 7.100000e+02
  %"$phi82.0.2.0" = select i1 %.29, double %arg.x., double 7.100000e+02
  %.46 = fmul contract double %"$phi82.0.2.0", 0x3FF71547652B82FE
  %.47 = fadd contract double %.46, 0x4338000000000000
  %.48 = fadd contract double %.47, 0xC338000000000000
  %.49 = fmul contract double %.48, 0x3FE62E42FEE00000
  %.50 = fsub contract double %"$phi82.0.2.0", %.49
  %.51 = fmul contract double %.48, 0x3DEA39EF35793C76
  %.52 = fsub contract double %.50, %.51
  %.53 = fmul contract double %.52, 0x3FB3B13B13B13B14
  %.55 = fadd contract double %.53, 1.000000e+00
  %.56 = fmul contract double %.52, %.55
  %.57 = fmul contract double %.56, 0x3FB5555555555555
  %.59 = fadd contract double %.57, 1.000000e+00
  %.60 = fmul contract double %.52, %.59
  %.61 = fmul contract double %.60, 0x3FB745D1745D1746
  %.63 = fadd contract double %.61, 1.000000e+00
  %.64 = fmul contract double %.52, %.63
  %.65 = fmul contract double %.64, 1.000000e-01
  %.67 = fadd contract double %.65, 1.000000e+00
  %.68 = fmul contract double %.52, %.67
  %.69 = fmul contract double %.68, 0x3FBC71C71C71C71C
  %.71 = fadd contract double %.69, 1.000000e+00
  %.72 = fmul contract double %.52, %.71
  %.73 = fmul contract double %.72, 1.250000e-01
  %.75 = fadd contract double %.73, 1.000000e+00
  %.76 = fmul contract double %.52, %.75
  %.77 = fmul contract double %.76, 0x3FC2492492492492
  %.79 = fadd contract double %.77, 1.000000e+00
  %.80 = fmul contract double %.52, %.79
  %.81 = fmul contract double %.80, 0x3FC5555555555555
  %.83 = fadd contract double %.81, 1.000000e+00
  %.84 = fmul contract double %.52, %.83
  %.85 = fmul contract double %.84, 2.000000e-01
  %.87 = fadd contract double %.85, 1.000000e+00
  %.88 = fmul contract double %.52, %.87
  %.89 = fmul contract double %.88, 2.500000e-01
  %.91 = fadd contract double %.89, 1.000000e+00
  %.92 = fmul contract double %.52, %.91
  %.93 = fmul contract double %.92, 0x3FD5555555555555
  %.95 = fadd contract double %.93, 1.000000e+00
  %.96 = fmul contract double %.52, %.95
  %.97 = fmul contract double %.96, 5.000000e-01
  %.99 = fadd contract double %.97, 1.000000e+00
  %.100 = fmul contract double %.52, %.99
  %.102 = fadd contract double %.100, 1.000000e+00
  %.103 = fadd contract double %.48, 0x4338000000000000
  %.104 = bitcast double %.103 to i64
  %.105 = shl i64 %.104, 52
  %.106 = add i64 %.105, 4607182418800017408
  %.107 = bitcast i64 %.106 to double
  %.108 = fmul contract double %.102, %.107
  store double %.108, ptr %retptr, align 8
  ret i32 0
}

define i64 @follow_turning(i64 %a0, i64 %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @follow_turning.119(ptr nonnull %r, ptr nonnull %e, i64 %a0, i64 %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9)
  ret i64 0
}

define internal i32 @follow_turning.119(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.steps, i64 %arg.count, i64 %arg.channels, ptr noalias %arg.step, ptr noalias %arg.rate, ptr noalias %arg.scale, ptr noalias %arg.drive, ptr noalias %arg.state, ptr noalias %arg.room, ptr noalias %arg.found) noinline {
entry:
  %.320 = alloca double, align 8
  store double 0.000000e+00, ptr %.320, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.346 = alloca [2 x double], align 8
  %.fca.1.gep = getelementptr inbounds nuw i8, ptr %.346, i64 8
  %excinfo.2 = alloca ptr, align 8
  call void @llvm.memset.p0.i64(ptr nonnull align 8 dereferenceable(16) %.346, i8 0, i64 16, i1 false)
  store ptr null, ptr %excinfo.2, align 8
  %.128250.not = icmp slt i64 %arg.count, 1
  br i1 %.128250.not, label %B1664, label %B60.if.lr.ph

B60.if.lr.ph:
  %.35 = shl nsw i64 %arg.steps, 2
  %.33 = shl nsw i64 %arg.steps, 1
  %.250238.not = icmp slt i64 %arg.steps, 1
  %0 = getelementptr double, ptr %arg.room, i64 %arg.steps
  %1 = getelementptr double, ptr %arg.room, i64 %.33
  %.idx235 = mul i64 %arg.steps, 24
  %2 = getelementptr i8, ptr %arg.room, i64 %.idx235
  %3 = getelementptr double, ptr %arg.room, i64 %.35
  %.idx236 = mul i64 %arg.steps, 40
  %4 = getelementptr i8, ptr %arg.room, i64 %.idx236
  %storemerge232 = call i64 @llvm.smax.i64(i64 %arg.channels, i64 0)
  %.807247.not = icmp slt i64 %arg.channels, 1
  %.849 = add nsw i64 %arg.steps, 1
  %.961241.not = icmp slt i64 %arg.steps, 1
  %5 = getelementptr double, ptr %arg.room, i64 %arg.steps
  %6 = getelementptr double, ptr %arg.room, i64 %.33
  %7 = getelementptr double, ptr %arg.room, i64 %.35
  %.idx = mul i64 %arg.steps, 24
  %8 = getelementptr i8, ptr %arg.room, i64 %.idx
  %.idx234 = mul i64 %arg.steps, 40
  %9 = getelementptr i8, ptr %arg.room, i64 %.idx234
  br label %B60.if

B58.loopexit:
  %exitcond257.not = icmp eq i64 %.141, %arg.count
  br i1 %exitcond257.not, label %B1664, label %B60.if

B1116:
  br i1 %.807247.not, label %B58.loopexit, label %B1166.if.lr.ph

B1166.if.lr.ph:
  %.723 = mul nuw nsw i64 %.69.0251, %arg.channels
  %.874 = getelementptr double, ptr %arg.scale, i64 %.69.0251
  %.875 = load double, ptr %.874, align 8
  br label %B1166.if

B1618:
  %yi.2.2.lcssa = phi double [ %.862, %B1166.if ], [ %.1060, %B1294.if ]
  %yr.2.2.lcssa = phi double [ %.856, %B1166.if ], [ %.1054, %B1294.if ]
  store double %yr.2.2.lcssa, ptr %.855, align 8
  store double %yi.2.2.lcssa, ptr %.861, align 8
  %.807 = icmp sgt i64 %.754.0249, 1
  br i1 %.807, label %B1166.if, label %B58.loopexit

common.ret:
  %common.ret.op = phi i32 [ 0, %B1664 ], [ %.350, %B98.endif.if ], [ %.324, %B98.if ]
  ret i32 %common.ret.op

B1664:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B60.if:
  %.69.0251 = phi i64 [ 0, %B60.if.lr.ph ], [ %.141, %B58.loopexit ]
  %.141 = add nuw nsw i64 %.69.0251, 1
  br i1 %.250238.not, label %B1116, label %B96.if.lr.ph

B96.if.lr.ph:
  %.298.idx = shl i64 %.69.0251, 4
  %.298 = getelementptr i8, ptr %arg.rate, i64 %.298.idx
  %.299 = load double, ptr %.298, align 8
  %.309 = getelementptr i8, ptr %.298, i64 8
  %.310 = load double, ptr %.309, align 8
  br label %B96.if

B96.if:
  %.193.0239 = phi i64 [ 0, %B96.if.lr.ph ], [ %.263, %B98.endif.endif ]
  %.263 = add nuw nsw i64 %.193.0239, 1
  %.293 = getelementptr double, ptr %arg.step, i64 %.193.0239
  %.294 = load double, ptr %.293, align 8
  %.300 = fmul contract double %.294, %.299
  %.311 = fmul contract double %.294, %.310
  store double 0.000000e+00, ptr %.320, align 8
  %.324 = call i32 @exponential.118(ptr nonnull %.320, ptr nonnull %excinfo.1, double %.300)
  %.334 = load double, ptr %.320, align 8
  switch i32 %.324, label %B98.if [
    i32 -2, label %B98.endif
    i32 0, label %B98.endif
  ]

B98.if:
  %.332 = icmp sgt i32 %.324, 0
  %.325 = load ptr, ptr %excinfo.1, align 8
  %.333 = select i1 %.332, ptr %.325, ptr undef
  store ptr %.333, ptr %excinfo, align 8
  br label %common.ret

B98.endif:
  call void @llvm.memset.p0.i64(ptr nonnull align 8 dereferenceable(16) %.346, i8 0, i64 16, i1 false)
  %.350 = call i32 @sine_and_cosine.114(ptr nonnull %.346, ptr nonnull %excinfo.2, double %.311)
  switch i32 %.350, label %B98.endif.if [
    i32 -2, label %B98.endif.endif
    i32 0, label %B98.endif.endif
  ]

B98.endif.if:
  %.358 = icmp sgt i32 %.350, 0
  %.351 = load ptr, ptr %excinfo.2, align 8
  %.359 = select i1 %.358, ptr %.351, ptr undef
  store ptr %.359, ptr %excinfo, align 8
  br label %common.ret

B98.endif.endif:
  %.360.fca.1.load = load double, ptr %.fca.1.gep, align 8
  %.360.fca.0.load = load double, ptr %.346, align 8
  %.372 = fmul contract double %.334, %.360.fca.1.load
  %.373 = fmul contract double %.334, %.360.fca.0.load
  %.382 = fmul contract double %.300, %.300
  %.385 = fmul contract double %.311, %.311
  %.386 = fadd contract double %.382, %.385
  %.388 = fmul contract double %.300, 0x3FC2492492492492
  %.390 = fadd contract double %.388, 1.000000e+00
  %.392 = fmul contract double %.311, 0x3FC2492492492492
  %.394 = fmul contract double %.300, %.390
  %.396 = fmul contract double %.311, %.392
  %.397 = fsub contract double %.394, %.396
  %.398 = fmul contract double %.397, 0x3FC5555555555555
  %.400 = fadd contract double %.398, 1.000000e+00
  %.402 = fmul contract double %.300, %.392
  %.404 = fmul contract double %.311, %.390
  %.405 = fadd contract double %.402, %.404
  %.406 = fmul contract double %.405, 0x3FC5555555555555
  %.408 = fmul contract double %.300, %.400
  %.410 = fmul contract double %.311, %.406
  %.411 = fsub contract double %.408, %.410
  %.412 = fmul contract double %.411, 2.000000e-01
  %.414 = fadd contract double %.412, 1.000000e+00
  %.416 = fmul contract double %.300, %.406
  %.418 = fmul contract double %.311, %.400
  %.419 = fadd contract double %.416, %.418
  %.420 = fmul contract double %.419, 2.000000e-01
  %.422 = fmul contract double %.300, %.414
  %.424 = fmul contract double %.311, %.420
  %.425 = fsub contract double %.422, %.424
  %.430 = fmul contract double %.425, 2.500000e-01
  %.432 = fadd contract double %.430, 1.000000e+00
  %.434 = fmul contract double %.300, %.420
  %.436 = fmul contract double %.311, %.414
  %.437 = fadd contract double %.434, %.436
  %.442 = fmul contract double %.437, 2.500000e-01
  %.444 = fmul contract double %.300, %.432
  %.446 = fmul contract double %.311, %.442
  %.447 = fsub contract double %.444, %.446
  %.448 = fmul contract double %.447, 0x3FD5555555555555
  %.450 = fadd contract double %.448, 1.000000e+00
  %.455 = fmul contract double %.450, 5.000000e-01
  %.457 = fmul contract double %.300, %.442
  %.459 = fmul contract double %.311, %.432
  %.460 = fadd contract double %.457, %.459
  %.461 = fmul contract double %.460, 0x3FD5555555555555
  %.466 = fmul contract double %.461, 5.000000e-01
  %.477 = fdiv contract double 1.000000e+00, %.386
  %.479 = fmul contract double %.300, %.477
  %.481 = fneg contract double %.311
  %.482 = fmul contract double %.477, %.481
  %.485 = fadd contract double %.372, -1.000000e+00
  %.486 = fmul contract double %.479, %.485
  %.488 = fmul contract double %.482, %.373
  %.489 = fsub contract double %.486, %.488
  %.496 = fmul contract double %.482, %.485
  %.498 = fmul contract double %.479, %.373
  %.499 = fadd contract double %.496, %.498
  %.505 = fadd contract double %.489, -1.000000e+00
  %.506 = fmul contract double %.479, %.505
  %.508 = fmul contract double %.482, %.499
  %.509 = fsub contract double %.506, %.508
  %.513 = fmul contract double %.482, %.505
  %.515 = fmul contract double %.479, %.499
  %.516 = fadd contract double %.515, %.513
  %.524 = fcmp contract olt double %.386, 1.000000e-04
  %.534 = fmul contract double %.300, %.455
  %.536 = fadd contract double %.534, 1.000000e+00
  %.539 = fmul contract double %.311, %.466
  %.540 = fsub contract double %.536, %.539
  %"$phi876.2.2.2" = select i1 %.524, double %.540, double %.489
  %.563 = fmul contract double %.300, %.466
  %.568 = fmul contract double %.311, %.455
  %.571 = fadd contract double %.563, %.568
  %"$phi906.2.2.2" = select i1 %.524, double %.571, double %.499
  %"$phi918.2.2.2" = select i1 %.524, double %.455, double %.509
  %"$phi930.2.2.2" = select i1 %.524, double %.466, double %.516
  %.644 = getelementptr double, ptr %arg.room, i64 %.193.0239
  store double %.372, ptr %.644, align 8
  %.653 = getelementptr double, ptr %0, i64 %.193.0239
  store double %.373, ptr %.653, align 8
  %.662 = fmul contract double %.294, %"$phi876.2.2.2"
  %.670 = fmul contract double %.294, %"$phi906.2.2.2"
  %.677 = getelementptr double, ptr %1, i64 %.193.0239
  store double %.662, ptr %.677, align 8
  %.685 = getelementptr double, ptr %2, i64 %.193.0239
  store double %.670, ptr %.685, align 8
  %.692 = fmul contract double %.294, %"$phi918.2.2.2"
  %.699 = fmul contract double %.294, %"$phi930.2.2.2"
  %.704 = getelementptr double, ptr %3, i64 %.193.0239
  store double %.692, ptr %.704, align 8
  %.714 = getelementptr double, ptr %4, i64 %.193.0239
  store double %.699, ptr %.714, align 8
  %exitcond.not = icmp eq i64 %arg.steps, %.263
  br i1 %exitcond.not, label %B1116, label %B96.if

B1166.if:
  %.754.0249 = phi i64 [ %storemerge232, %B1166.if.lr.ph ], [ %.816, %B1618 ]
  %.751.0248 = phi i64 [ %.723, %B1166.if.lr.ph ], [ %.820, %B1618 ]
  %.816 = add nsw i64 %.754.0249, -1
  %.820 = add i64 %.751.0248, 1
  %.851 = mul nsw i64 %.751.0248, %.849
  %.855.idx = shl i64 %.751.0248, 4
  %.855 = getelementptr i8, ptr %arg.state, i64 %.855.idx
  %.856 = load double, ptr %.855, align 8
  %.861 = getelementptr i8, ptr %.855, i64 8
  %.862 = load double, ptr %.861, align 8
  %.876 = fmul contract double %.862, %.875
  %.879 = getelementptr double, ptr %arg.found, i64 %.851
  store double %.876, ptr %.879, align 8
  br i1 %.961241.not, label %B1618, label %B1294.if

B1294.if:
  %yr.2.2245 = phi double [ %.1054, %B1294.if ], [ %.856, %B1166.if ]
  %yi.2.2244 = phi double [ %.1060, %B1294.if ], [ %.862, %B1166.if ]
  %.905.0242 = phi i64 [ %.974, %B1294.if ], [ 0, %B1166.if ]
  %.974 = add nuw nsw i64 %.905.0242, 1
  %.1000 = add nsw i64 %.905.0242, %.851
  %.1002 = getelementptr double, ptr %arg.drive, i64 %.1000
  %.1003 = load double, ptr %.1002, align 8
  %.1006 = add nsw i64 %.1000, 1
  %.1008 = getelementptr double, ptr %arg.drive, i64 %.1006
  %.1009 = load double, ptr %.1008, align 8
  %.1010 = fsub contract double %.1009, %.1003
  %.1012 = getelementptr double, ptr %arg.room, i64 %.905.0242
  %.1013 = load double, ptr %.1012, align 8
  %.1017 = getelementptr double, ptr %5, i64 %.905.0242
  %.1018 = load double, ptr %.1017, align 8
  %.1022 = getelementptr double, ptr %6, i64 %.905.0242
  %.1023 = load double, ptr %.1022, align 8
  %.1024 = fmul contract double %.1003, %.1023
  %.1028 = getelementptr double, ptr %7, i64 %.905.0242
  %.1029 = load double, ptr %.1028, align 8
  %.1030 = fmul contract double %.1010, %.1029
  %.1031 = fadd contract double %.1024, %.1030
  %.1037 = getelementptr double, ptr %8, i64 %.905.0242
  %.1038 = load double, ptr %.1037, align 8
  %.1039 = fmul contract double %.1003, %.1038
  %.1045 = getelementptr double, ptr %9, i64 %.905.0242
  %.1046 = load double, ptr %.1045, align 8
  %.1047 = fmul contract double %.1010, %.1046
  %.1048 = fadd contract double %.1039, %.1047
  %.1050 = fmul contract double %yr.2.2245, %.1013
  %.1051 = fadd contract double %.1050, %.1031
  %.1053 = fmul contract double %yi.2.2244, %.1018
  %.1054 = fsub contract double %.1051, %.1053
  %.1056 = fmul contract double %yi.2.2244, %.1013
  %.1057 = fadd contract double %.1056, %.1048
  %.1059 = fmul contract double %yr.2.2245, %.1018
  %.1060 = fadd contract double %.1059, %.1057
  %.1069 = fmul contract double %.875, %.1060
  %.1074 = getelementptr double, ptr %arg.found, i64 %.1006
  store double %.1069, ptr %.1074, align 8
  %exitcond256.not = icmp eq i64 %arg.steps, %.974
  br i1 %exitcond256.not, label %B1618, label %B1294.if
}

define i64 @have_signs(i64 %a0, i64 %a1, i64 %a2, i64 %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @have_signs.120(ptr nonnull %r, ptr nonnull %e, i64 %a0, i64 %a1, i64 %a2, i64 %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9)
  ret i64 0
}

define internal i32 @have_signs.120(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.matrices, i64 %arg.entries, i64 %arg.count, i64 %arg.width, ptr noalias %arg.lower, ptr noalias %arg.upper, ptr noalias %arg.signs, ptr noalias %arg.data, ptr noalias %arg.band, ptr noalias %arg.found) noinline {
entry:
  %.32 = add i64 %arg.width, 1
  %.123287.not = icmp slt i64 %arg.matrices, 1
  br i1 %.123287.not, label %B784, label %B68.if.lr.ph

B68.if.lr.ph:
  %.31 = add nsw i64 %arg.width, %arg.count
  %.33 = mul nsw i64 %.31, %.32
  %0 = call i64 @llvm.smax.i64(i64 %.33, i64 0)
  %storemerge267 = shl nuw i64 %0, 1
  %.245272 = icmp sgt i64 %storemerge267, 0
  %.371275.not = icmp slt i64 %arg.entries, 1
  %1 = getelementptr double, ptr %arg.band, i64 %.33
  %.555284.not = icmp slt i64 %arg.count, 1
  %storemerge270 = call i64 @llvm.smax.i64(i64 %arg.width, i64 0)
  %.722281.not = icmp slt i64 %arg.width, 1
  %2 = getelementptr double, ptr %arg.band, i64 %.33
  %3 = getelementptr double, ptr %arg.band, i64 %.33
  %4 = shl i64 %0, 4
  br label %B68.if

B124:
  br i1 %.371275.not, label %B306, label %B154.if.lr.ph

B154.if.lr.ph:
  %.421 = mul nuw nsw i64 %.64.0288, %arg.entries
  %5 = getelementptr double, ptr %arg.data, i64 %.421
  %.445 = mul nuw nsw i64 %.64.0288, %arg.entries
  %6 = getelementptr double, ptr %arg.data, i64 %.445
  br label %B154.if

B182:
  %.416 = zext nneg i32 %.415 to i64
  %.425 = getelementptr double, ptr %5, i64 %.315.0276
  %.426 = load double, ptr %.425, align 8
  %.433 = getelementptr double, ptr %arg.band, i64 %.416
  store double %.426, ptr %.433, align 8
  br label %B228

B228:
  %.438 = getelementptr i32, ptr %arg.upper, i64 %.315.0276
  %.439 = load i32, ptr %.438, align 4
  %.441 = icmp sgt i32 %.439, -1
  br i1 %.441, label %B252, label %B304

B252:
  %.440 = zext nneg i32 %.439 to i64
  %.449 = getelementptr double, ptr %6, i64 %.315.0276
  %.450 = load double, ptr %.449, align 8
  %.461 = getelementptr double, ptr %1, i64 %.440
  store double %.450, ptr %.461, align 8
  br label %B304

B304:
  %exitcond.not = icmp eq i64 %arg.entries, %.384
  br i1 %exitcond.not, label %B306, label %B154.if

B306:
  %.473 = getelementptr i64, ptr %arg.found, i64 %.64.0288
  store i64 1, ptr %.473, align 8
  br i1 %.555284.not, label %B780, label %B346.if

B346.loopexit:
  %exitcond292.not = icmp eq i64 %arg.count, %.568
  br i1 %exitcond292.not, label %B780, label %B346.if

B422:
  store i64 0, ptr %.473, align 8
  br label %B780

B436:
  br i1 %.722281.not, label %B346.loopexit, label %B468.if.lr.ph

B468.if.lr.ph:
  %7 = getelementptr double, ptr %2, i64 %.598
  br label %B468.if

B512:
  %.781 = getelementptr double, ptr %.612, i64 %.666.0282
  %.782 = load double, ptr %.781, align 8
  %.783 = fcmp contract une double %.782, 0.000000e+00
  br i1 %.783, label %B542, label %B776

B542:
  %.795 = fdiv contract double %.774, %.613
  %.800 = getelementptr double, ptr %.612, i64 %.666.0282
  %.801 = load double, ptr %.800, align 8
  %.806 = fdiv contract double %.801, %.613
  %.851 = sub i64 %.32, %.666.0282
  %.894278.not = icmp slt i64 %.851, 1
  br i1 %.894278.not, label %B776, label %B630.if.lr.ph

B630.if.lr.ph:
  %.934 = mul nsw i64 %.765, %.32
  %.935 = sub i64 %.934, %.666.0282
  br label %B630.if

B776:
  %exitcond291.not = icmp eq i64 %.666.0282, %storemerge270
  br i1 %exitcond291.not, label %B346.loopexit, label %B468.if

B780:
  %exitcond293.not = icmp eq i64 %.136, %arg.matrices
  br i1 %exitcond293.not, label %B784, label %B68.if

B784:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B68.if:
  %.64.0288 = phi i64 [ 0, %B68.if.lr.ph ], [ %.136, %B780 ]
  %.136 = add nuw nsw i64 %.64.0288, 1
  br i1 %.245272, label %B108.if.preheader, label %B124

B108.if.preheader:
  call void @llvm.memset.p0.i64(ptr align 8 %arg.band, i8 0, i64 %4, i1 false)
  br label %B124

B154.if:
  %.315.0276 = phi i64 [ 0, %B154.if.lr.ph ], [ %.384, %B304 ]
  %.384 = add nuw nsw i64 %.315.0276, 1
  %.414 = getelementptr i32, ptr %arg.lower, i64 %.315.0276
  %.415 = load i32, ptr %.414, align 4
  %.417 = icmp sgt i32 %.415, -1
  br i1 %.417, label %B182, label %B228

B346.if:
  %.499.0285 = phi i64 [ %.568, %B346.loopexit ], [ 0, %B306 ]
  %.568 = add nuw nsw i64 %.499.0285, 1
  %.598 = mul nsw i64 %.499.0285, %.32
  %.612 = getelementptr double, ptr %arg.band, i64 %.598
  %.613 = load double, ptr %.612, align 8
  %.619 = getelementptr double, ptr %arg.signs, i64 %.499.0285
  %.620 = load double, ptr %.619, align 8
  %.622 = fmul contract double %.613, %.620
  %.623 = fcmp contract olt double %.622, 0.000000e+00
  br i1 %.623, label %B436, label %B422

B468.if:
  %.666.0282 = phi i64 [ 1, %B468.if.lr.ph ], [ %.735, %B776 ]
  %.735 = add nuw i64 %.666.0282, 1
  %.765 = add nuw nsw i64 %.666.0282, %.499.0285
  %.773 = getelementptr double, ptr %7, i64 %.666.0282
  %.774 = load double, ptr %.773, align 8
  %.775 = fcmp contract une double %.774, 0.000000e+00
  br i1 %.775, label %B542, label %B512

B630.if:
  %.838.0279 = phi i64 [ %.666.0282, %B630.if.lr.ph ], [ %.907, %B630.if ]
  %.907 = add nuw i64 %.838.0279, 1
  %.937 = add i64 %.935, %.838.0279
  %.939 = getelementptr double, ptr %arg.band, i64 %.937
  %.940 = load double, ptr %.939, align 8
  %.944 = getelementptr double, ptr %.612, i64 %.838.0279
  %.945 = load double, ptr %.944, align 8
  %.947 = fmul contract double %.795, %.945
  %.948 = fsub contract double %.940, %.947
  store double %.948, ptr %.939, align 8
  %.955 = getelementptr double, ptr %3, i64 %.937
  %.956 = load double, ptr %.955, align 8
  %.960 = getelementptr double, ptr %7, i64 %.838.0279
  %.961 = load double, ptr %.960, align 8
  %.963 = fmul contract double %.806, %.961
  %.964 = fsub contract double %.956, %.963
  store double %.964, ptr %.955, align 8
  %exitcond290.not = icmp eq i64 %.838.0279, %arg.width
  br i1 %exitcond290.not, label %B776, label %B630.if
}

define i64 @follow_equilibria(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, i64 %a6, ptr %a7, ptr %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, i64 %a13, ptr %a14, i64 %a15, i64 %a16, ptr %a17, ptr %a18, ptr %a19, ptr %a20, ptr %a21, ptr %a22, ptr %a23) {
  %r = alloca i64, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @follow_equilibria.121(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, i64 %a6, ptr %a7, ptr %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, i64 %a13, ptr %a14, i64 %a15, i64 %a16, ptr %a17, ptr %a18, ptr %a19, ptr %a20, ptr %a21, ptr %a22, ptr %a23)
  %v = load i64, ptr %r, align 8
  ret i64 %v
}

define internal i32 @follow_equilibria.121(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.pos, ptr noalias %arg.numbers, i64 %arg.blocks, ptr noalias %arg.own, ptr noalias %arg.slots, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.mass, i64 %arg.count, ptr noalias %arg.times, i64 %arg.first, i64 %arg.last, ptr noalias %arg.settings, ptr noalias %arg.before, ptr noalias %arg.now, ptr noalias %arg.clock, ptr noalias %arg.Y, ptr noalias %arg.outputs, ptr noalias %arg.work) noinline {
entry:
  %.291 = alloca ptr, align 8
  store ptr null, ptr %.291, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.475 = alloca ptr, align 8
  store ptr null, ptr %.475, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.520 = alloca ptr, align 8
  store ptr null, ptr %.520, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.553 = alloca i64, align 8
  store i64 0, ptr %.553, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.711 = alloca ptr, align 8
  store ptr null, ptr %.711, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.745 = alloca ptr, align 8
  store ptr null, ptr %.745, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.920 = alloca ptr, align 8
  store ptr null, ptr %.920, align 8
  %excinfo.7 = alloca ptr, align 8
  store ptr null, ptr %excinfo.7, align 8
  %.951 = alloca i64, align 8
  store i64 0, ptr %.951, align 8
  %excinfo.8 = alloca ptr, align 8
  store ptr null, ptr %excinfo.8, align 8
  %.998 = alloca ptr, align 8
  store ptr null, ptr %.998, align 8
  %excinfo.9 = alloca ptr, align 8
  store ptr null, ptr %excinfo.9, align 8
  %.1025 = alloca double, align 8
  store double 0.000000e+00, ptr %.1025, align 8
  %excinfo.10 = alloca ptr, align 8
  store ptr null, ptr %excinfo.10, align 8
  %.1082 = alloca ptr, align 8
  store ptr null, ptr %.1082, align 8
  %excinfo.11 = alloca ptr, align 8
  store ptr null, ptr %excinfo.11, align 8
  %.1155 = alloca i64, align 8
  store i64 0, ptr %.1155, align 8
  %excinfo.12 = alloca ptr, align 8
  store ptr null, ptr %excinfo.12, align 8
  %.1258 = alloca ptr, align 8
  store ptr null, ptr %.1258, align 8
  %excinfo.13 = alloca ptr, align 8
  store ptr null, ptr %excinfo.13, align 8
  %.1286 = alloca ptr, align 8
  store ptr null, ptr %.1286, align 8
  %excinfo.14 = alloca ptr, align 8
  store ptr null, ptr %excinfo.14, align 8
  %.1318 = alloca ptr, align 8
  store ptr null, ptr %.1318, align 8
  %excinfo.15 = alloca ptr, align 8
  store ptr null, ptr %excinfo.15, align 8
  %.76 = load i64, ptr %arg.layout, align 8
  %.78 = getelementptr i8, ptr %arg.layout, i64 16
  %.79 = load i64, ptr %.78, align 8
  %.85 = getelementptr double, ptr %arg.work, i64 %.76
  %.idx = shl i64 %.76, 4
  %0 = getelementptr i8, ptr %arg.work, i64 %.idx
  %.89 = getelementptr i8, ptr %0, i64 8
  %.101 = getelementptr double, ptr %.89, i64 %.76
  %.108.idx = shl i64 %arg.blocks, 5
  %.108 = getelementptr i8, ptr %.101, i64 %.108.idx
  %.115.idx = shl i64 %arg.blocks, 4
  %.115 = getelementptr i8, ptr %.108, i64 %.115.idx
  %.120 = getelementptr double, ptr %.115, i64 %.79
  %.126 = getelementptr i8, ptr %arg.layout, i64 24
  %.127 = load i64, ptr %.126, align 8
  %1 = getelementptr double, ptr %.120, i64 %.79
  %2 = getelementptr i8, ptr %1, i64 8
  %.130 = getelementptr double, ptr %2, i64 %.127
  %.135 = getelementptr i8, ptr %arg.layout, i64 48
  %.136 = load i64, ptr %.135, align 8
  %.138 = getelementptr double, ptr %.130, i64 %.136
  %.225351 = icmp sgt i64 %arg.count, 0
  br i1 %.225351, label %B458.lr.ph, label %B1744

B458.lr.ph:
  %.169.1354 = add nsw i64 %arg.count, -1
  %.267 = getelementptr i8, ptr %arg.clock, i64 8
  %.316 = getelementptr i8, ptr %arg.settings, i64 24
  %.403345.not360 = icmp slt i64 %.76, 1
  %.504 = getelementptr i8, ptr %arg.layout, i64 8
  %3 = getelementptr double, ptr %arg.Y, i64 %.76
  %.551 = getelementptr i8, ptr %arg.settings, i64 16
  %.849348.not = icmp slt i64 %.76, 1
  %.913 = getelementptr i32, ptr %arg.lu_start, i64 %arg.blocks
  %.1057 = getelementptr i8, ptr %arg.settings, i64 8
  %.1148 = getelementptr i8, ptr %arg.settings, i64 32
  %.267.promoted = load double, ptr %.267, align 8
  %arg.clock.promoted = load double, ptr %arg.clock, align 8
  br label %B458

B458:
  %.268358359 = phi double [ %arg.clock.promoted, %B458.lr.ph ], [ %.268358, %B1560.endif.endif.endif ]
  %.268358 = phi double [ %.267.promoted, %B458.lr.ph ], [ %.276, %B1560.endif.endif.endif ]
  %.215.sroa.0.0357 = phi i64 [ 0, %B458.lr.ph ], [ %.215.sroa.0.0, %B1560.endif.endif.endif ]
  %.169.1356 = phi i64 [ %.169.1354, %B458.lr.ph ], [ %.169.1, %B1560.endif.endif.endif ]
  %.166.1355 = phi i64 [ 1, %B458.lr.ph ], [ %.166.1, %B1560.endif.endif.endif ]
  %.272 = fsub contract double %.268358, %.268358359
  %.275 = getelementptr double, ptr %arg.times, i64 %.215.sroa.0.0357
  %.276 = load double, ptr %.275, align 8
  %.280 = fsub contract double %.276, %.268358
  store ptr null, ptr %.291, align 8
  %.295 = call i32 @copy.27(ptr nonnull %.291, ptr nonnull %excinfo.1, i64 %.76, ptr %arg.now, ptr %arg.work)
  switch i32 %.295, label %B458.if [
    i32 -2, label %B458.endif
    i32 0, label %B458.endif
  ]

B632.if.lr.ph:
  %.449 = fdiv contract double %.280, %.272
  br label %B632.if

B712:
  store ptr null, ptr %.475, align 8
  %.479 = call i32 @copy.27(ptr nonnull %.475, ptr nonnull %excinfo.2, i64 %.76, ptr %arg.work, ptr %arg.Y)
  switch i32 %.479, label %B712.if [
    i32 -2, label %B712.endif
    i32 0, label %B712.endif
  ]

B946:
  %.603.0 = phi i64 [ %storemerge231, %B712.endif.endif.endif ], [ %.670, %B1384.endif ]
  %size.2.1 = phi double [ 0x7FF0000000000000, %B712.endif.endif.endif ], [ %.1039, %B1384.endif ]
  %.661 = icmp sgt i64 %.603.0, 0
  br i1 %.661, label %B948.if, label %B1552

B1102:
  %.898 = getelementptr double, ptr %.85, i64 %.793.0349
  store double 0.000000e+00, ptr %.898, align 8
  br label %B1112

B1112:
  %exitcond481.not = icmp eq i64 %.76, %.862
  br i1 %exitcond481.not, label %B1114, label %B1074.if

B1114:
  %.914 = load i32, ptr %.913, align 4
  store ptr null, ptr %.920, align 8
  %.924 = call i32 @lu_fill.23(ptr nonnull %.920, ptr nonnull %excinfo.7, i64 %.76, i32 %.914, ptr %.120, ptr %arg.own, ptr %arg.mass, double 1.000000e+00, ptr %.115)
  switch i32 %.924, label %B1114.if [
    i32 -2, label %B1114.endif
    i32 0, label %B1114.endif
  ]

B1220:
  store ptr null, ptr %.998, align 8
  %.1002 = call i32 @lu_solve.19(ptr nonnull %.998, ptr nonnull %excinfo.9, i64 %.76, ptr %arg.slots, i64 %arg.blocks, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %.115, ptr %.85, ptr %.89, ptr %.108)
  switch i32 %.1002, label %B1220.if [
    i32 -2, label %B1220.endif
    i32 0, label %B1220.endif
  ]

B1340:
  %.1058 = load double, ptr %.1057, align 8
  %.1060 = fmul contract double %size.2.1, %.1058
  %.1064 = fcmp contract ogt double %.1039, %.1060
  br i1 %.1064, label %B1552, label %B1384

B1384:
  store ptr null, ptr %.1082, align 8
  %.1086 = call i32 @add_scaled.29(ptr nonnull %.1082, ptr nonnull %excinfo.11, i64 %.76, double 1.000000e+00, ptr %.89, ptr %arg.Y)
  switch i32 %.1086, label %B1384.if [
    i32 -2, label %B1384.endif
    i32 0, label %B1384.endif
  ]

B1482:
  %.1149 = load double, ptr %.1148, align 8
  store i64 0, ptr %.1155, align 8
  %.1159 = call i32 @is_far.122(ptr nonnull %.1155, ptr nonnull %excinfo.12, i64 %arg.first, i64 %arg.last, double %.1149, ptr %arg.Y, ptr %arg.work, ptr %arg.now)
  switch i32 %.1159, label %B1482.if [
    i32 -2, label %B1482.endif
    i32 0, label %B1482.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ 0, %B1552 ], [ 0, %B1744 ], [ %.1322, %B1560.endif.endif.if ], [ %.1290, %B1560.endif.if ], [ %.1262, %B1560.if ], [ %.295, %B458.if ], [ %.479, %B712.if ], [ %.524, %B712.endif.if ], [ %.1159, %B1482.if ], [ %.557, %B712.endif.endif.if ], [ %.715, %B950.if ], [ %.1086, %B1384.if ], [ %.749, %B950.endif.if ], [ %.924, %B1114.if ], [ %.955, %B1114.endif.if ], [ %.1002, %B1220.if ], [ %.1029, %B1220.endif.if ]
  ret i32 %common.ret.op

B1552:
  store i64 %.215.sroa.0.0357, ptr %retptr, align 8
  br label %common.ret

B1560:
  store ptr null, ptr %.1258, align 8
  %.1262 = call i32 @copy.27(ptr nonnull %.1258, ptr nonnull %excinfo.13, i64 %.76, ptr %arg.now, ptr %arg.before)
  switch i32 %.1262, label %B1560.if [
    i32 -2, label %B1560.endif
    i32 0, label %B1560.endif
  ]

B1744:
  store i64 %arg.count, ptr %retptr, align 8
  br label %common.ret

B458.if:
  %.303 = icmp sgt i32 %.295, 0
  %.296 = load ptr, ptr %excinfo.1, align 8
  %.304 = select i1 %.303, ptr %.296, ptr undef
  store ptr %.304, ptr %excinfo, align 8
  br label %common.ret

B458.endif:
  %.317 = load double, ptr %.316, align 8
  %.319 = fmul contract double %.272, %.317
  %.321 = fcmp contract ugt double %.280, %.319
  %brmerge = select i1 %.321, i1 true, i1 %.403345.not360
  br i1 %brmerge, label %B712, label %B632.if.lr.ph

B632.if:
  %.347.0346 = phi i64 [ 0, %B632.if.lr.ph ], [ %.416, %B632.if ]
  %.416 = add nuw nsw i64 %.347.0346, 1
  %.442 = getelementptr double, ptr %arg.work, i64 %.347.0346
  %.443 = load double, ptr %.442, align 8
  %.451 = getelementptr double, ptr %arg.now, i64 %.347.0346
  %.452 = load double, ptr %.451, align 8
  %.454 = getelementptr double, ptr %arg.before, i64 %.347.0346
  %.455 = load double, ptr %.454, align 8
  %.456 = fsub contract double %.452, %.455
  %.457 = fmul contract double %.449, %.456
  %.458 = fadd contract double %.443, %.457
  store double %.458, ptr %.442, align 8
  %exitcond.not = icmp eq i64 %.76, %.416
  br i1 %exitcond.not, label %B712, label %B632.if

B712.if:
  %.487 = icmp sgt i32 %.479, 0
  %.480 = load ptr, ptr %excinfo.2, align 8
  %.488 = select i1 %.487, ptr %.480, ptr undef
  store ptr %.488, ptr %excinfo, align 8
  br label %common.ret

B712.endif:
  %.505 = load i64, ptr %.504, align 8
  %.509 = getelementptr double, ptr %3, i64 %.505
  store double %.276, ptr %.509, align 8
  store ptr null, ptr %.520, align 8
  %.524 = call i32 @drive.6(ptr nonnull %.520, ptr nonnull %excinfo.3, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.130, ptr %.138)
  switch i32 %.524, label %B712.endif.if [
    i32 -2, label %B712.endif.endif
    i32 0, label %B712.endif.endif
  ]

B712.endif.if:
  %.532 = icmp sgt i32 %.524, 0
  %.525 = load ptr, ptr %excinfo.3, align 8
  %.533 = select i1 %.532, ptr %.525, ptr undef
  store ptr %.533, ptr %excinfo, align 8
  br label %common.ret

B712.endif.endif:
  %.552 = load double, ptr %.551, align 8
  store i64 0, ptr %.553, align 8
  %.557 = call i32 @numba.123(ptr nonnull %.553, ptr nonnull %excinfo.4, double %.552)
  switch i32 %.557, label %B712.endif.endif.if [
    i32 -2, label %B712.endif.endif.endif
    i32 0, label %B712.endif.endif.endif
  ]

B712.endif.endif.if:
  %.565 = icmp sgt i32 %.557, 0
  %.558 = load ptr, ptr %excinfo.4, align 8
  %.566 = select i1 %.565, ptr %.558, ptr undef
  store ptr %.566, ptr %excinfo, align 8
  br label %common.ret

B712.endif.endif.endif:
  %.567 = load i64, ptr %.553, align 8
  %storemerge231 = call i64 @llvm.smax.i64(i64 %.567, i64 0)
  br label %B946

B948.if:
  %.670 = add nsw i64 %.603.0, -1
  store ptr null, ptr %.711, align 8
  %.715 = call i32 @residual.0(ptr nonnull %.711, ptr nonnull %excinfo.5, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.85, ptr %.130, ptr %.138)
  switch i32 %.715, label %B950.if [
    i32 -2, label %B950.endif
    i32 0, label %B950.endif
  ]

B950.if:
  %.723 = icmp sgt i32 %.715, 0
  %.716 = load ptr, ptr %excinfo.5, align 8
  %.724 = select i1 %.723, ptr %.716, ptr undef
  store ptr %.724, ptr %excinfo, align 8
  br label %common.ret

B950.endif:
  store ptr null, ptr %.745, align 8
  %.749 = call i32 @jacobian.4(ptr nonnull %.745, ptr nonnull %excinfo.6, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.pos, ptr %arg.numbers, ptr %arg.Y, ptr %.120, ptr %.130, ptr %.138)
  switch i32 %.749, label %B950.endif.if [
    i32 -2, label %B950.endif.endif
    i32 0, label %B950.endif.endif
  ]

B950.endif.if:
  %.757 = icmp sgt i32 %.749, 0
  %.750 = load ptr, ptr %excinfo.6, align 8
  %.758 = select i1 %.757, ptr %.750, ptr undef
  store ptr %.758, ptr %excinfo, align 8
  br label %common.ret

B950.endif.endif:
  br i1 %.849348.not, label %B1114, label %B1074.if

B1074.if:
  %.793.0349 = phi i64 [ %.862, %B1112 ], [ 0, %B950.endif.endif ]
  %.862 = add nuw nsw i64 %.793.0349, 1
  %.892 = getelementptr double, ptr %arg.mass, i64 %.793.0349
  %.893 = load double, ptr %.892, align 8
  %.894 = fcmp contract une double %.893, 0.000000e+00
  br i1 %.894, label %B1102, label %B1112

B1114.if:
  %.932 = icmp sgt i32 %.924, 0
  %.925 = load ptr, ptr %excinfo.7, align 8
  %.933 = select i1 %.932, ptr %.925, ptr undef
  store ptr %.933, ptr %excinfo, align 8
  br label %common.ret

B1114.endif:
  store i64 0, ptr %.951, align 8
  %.955 = call i32 @lu_factor.17(ptr nonnull %.951, ptr nonnull %excinfo.8, i64 %arg.blocks, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %.115, ptr %.101)
  switch i32 %.955, label %B1114.endif.if [
    i32 -2, label %B1114.endif.endif
    i32 0, label %B1114.endif.endif
  ]

B1114.endif.if:
  %.963 = icmp sgt i32 %.955, 0
  %.956 = load ptr, ptr %excinfo.8, align 8
  %.964 = select i1 %.963, ptr %.956, ptr undef
  store ptr %.964, ptr %excinfo, align 8
  br label %common.ret

B1114.endif.endif:
  %.965 = load i64, ptr %.951, align 8
  %.975.not = icmp eq i64 %.965, 0
  br i1 %.975.not, label %B1220, label %B1552

B1220.if:
  %.1010 = icmp sgt i32 %.1002, 0
  %.1003 = load ptr, ptr %excinfo.9, align 8
  %.1011 = select i1 %.1010, ptr %.1003, ptr undef
  store ptr %.1011, ptr %excinfo, align 8
  br label %common.ret

B1220.endif:
  store double 0.000000e+00, ptr %.1025, align 8
  %.1029 = call i32 @largest_of.124(ptr nonnull %.1025, ptr nonnull %excinfo.10, i64 %.76, ptr %.89)
  %.1039 = load double, ptr %.1025, align 8
  switch i32 %.1029, label %B1220.endif.if [
    i32 -2, label %B1220.endif.endif
    i32 0, label %B1220.endif.endif
  ]

B1220.endif.if:
  %.1037 = icmp sgt i32 %.1029, 0
  %.1030 = load ptr, ptr %excinfo.10, align 8
  %.1038 = select i1 %.1037, ptr %.1030, ptr undef
  store ptr %.1038, ptr %excinfo, align 8
  br label %common.ret

B1220.endif.endif:
  %.1053 = fsub contract double %.1039, %.1039
  %.1054 = fcmp contract ord double %.1053, 0.000000e+00
  br i1 %.1054, label %B1340, label %B1552

B1384.if:
  %.1094 = icmp sgt i32 %.1086, 0
  %.1087 = load ptr, ptr %excinfo.11, align 8
  %.1095 = select i1 %.1094, ptr %.1087, ptr undef
  store ptr %.1095, ptr %excinfo, align 8
  br label %common.ret

B1384.endif:
  %.1114 = load double, ptr %arg.settings, align 8
  %.1116 = fcmp contract ugt double %.1039, %.1114
  br i1 %.1116, label %B946, label %B1482

B1482.if:
  %.1167 = icmp sgt i32 %.1159, 0
  %.1160 = load ptr, ptr %excinfo.12, align 8
  %.1168 = select i1 %.1167, ptr %.1160, ptr undef
  store ptr %.1168, ptr %excinfo, align 8
  br label %common.ret

B1482.endif:
  %.1169 = load i64, ptr %.1155, align 8
  %.1179.not = icmp eq i64 %.1169, 0
  br i1 %.1179.not, label %B1560, label %B1552

B1560.if:
  %.1270 = icmp sgt i32 %.1262, 0
  %.1263 = load ptr, ptr %excinfo.13, align 8
  %.1271 = select i1 %.1270, ptr %.1263, ptr undef
  store ptr %.1271, ptr %excinfo, align 8
  br label %common.ret

B1560.endif:
  store ptr null, ptr %.1286, align 8
  %.1290 = call i32 @copy.27(ptr nonnull %.1286, ptr nonnull %excinfo.14, i64 %.76, ptr %arg.Y, ptr %arg.now)
  switch i32 %.1290, label %B1560.endif.if [
    i32 -2, label %B1560.endif.endif
    i32 0, label %B1560.endif.endif
  ]

B1560.endif.if:
  %.1298 = icmp sgt i32 %.1290, 0
  %.1291 = load ptr, ptr %excinfo.14, align 8
  %.1299 = select i1 %.1298, ptr %.1291, ptr undef
  store ptr %.1299, ptr %excinfo, align 8
  br label %common.ret

B1560.endif.endif:
  %.1313 = mul nsw i64 %.215.sroa.0.0357, %.76
  %.1315 = getelementptr double, ptr %arg.outputs, i64 %.1313
  store ptr null, ptr %.1318, align 8
  %.1322 = call i32 @copy.27(ptr nonnull %.1318, ptr nonnull %excinfo.15, i64 %.76, ptr %arg.Y, ptr %.1315)
  switch i32 %.1322, label %B1560.endif.endif.if [
    i32 -2, label %B1560.endif.endif.endif
    i32 0, label %B1560.endif.endif.endif
  ]

B1560.endif.endif.if:
  %.1330 = icmp sgt i32 %.1322, 0
  %.1323 = load ptr, ptr %excinfo.15, align 8
  %.1331 = select i1 %.1330, ptr %.1323, ptr undef
  store ptr %.1331, ptr %excinfo, align 8
  br label %common.ret

B1560.endif.endif.endif:
  store double %.268358, ptr %arg.clock, align 8
  store double %.276, ptr %.267, align 8
  %.225 = icmp sgt i64 %.169.1356, 0
  %.238 = zext i1 %.225 to i64
  %.166.1 = add i64 %.166.1355, %.238
  %.234 = sext i1 %.225 to i64
  %.169.1 = add nsw i64 %.169.1356, %.234
  %.215.sroa.0.0 = select i1 %.225, i64 %.166.1355, i64 0
  br i1 %.225, label %B458, label %B1744
}

define internal i32 @is_far.122(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.first, i64 %arg.last, double %arg.near, ptr noalias %arg.found, ptr noalias %arg.guess, ptr noalias %arg.now) noinline {
entry:
  %.159 = alloca double, align 8
  store double 0.000000e+00, ptr %.159, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.198 = alloca double, align 8
  store double 0.000000e+00, ptr %.198, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.237 = alloca double, align 8
  store double 0.000000e+00, ptr %.237, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.280 = alloca double, align 8
  store double 0.000000e+00, ptr %.280, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.69 = sub i64 %arg.last, %arg.first
  %.11450.not = icmp slt i64 %.69, 1
  br i1 %.11450.not, label %B300, label %B48.if

B300:
  %moved.2.0.lcssa = phi double [ 0.000000e+00, %entry ], [ %.253, %B50.endif.endif.endif ]
  %apart.2.0.lcssa = phi double [ 0.000000e+00, %entry ], [ %.214, %B50.endif.endif.endif ]
  %size.2.0.lcssa = phi double [ 1.000000e+00, %entry ], [ %.175, %B50.endif.endif.endif ]
  store double 0.000000e+00, ptr %.280, align 8
  %.286 = call i32 @numba.21(ptr nonnull %.280, ptr nonnull %excinfo.4, double %apart.2.0.lcssa, double %moved.2.0.lcssa)
  switch i32 %.286, label %B300.if [
    i32 -2, label %B300.endif
    i32 0, label %B300.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ 0, %B346 ], [ 0, %B350 ], [ %.286, %B300.if ], [ %.243, %B50.endif.endif.if ], [ %.165, %B50.if ], [ %.204, %B50.endif.if ]
  ret i32 %common.ret.op

B346:
  store i64 1, ptr %retptr, align 8
  br label %common.ret

B350:
  store i64 0, ptr %retptr, align 8
  br label %common.ret

B48.if:
  %size.2.055 = phi double [ %.175, %B50.endif.endif.endif ], [ 1.000000e+00, %entry ]
  %apart.2.054 = phi double [ %.214, %B50.endif.endif.endif ], [ 0.000000e+00, %entry ]
  %moved.2.053 = phi double [ %.253, %B50.endif.endif.endif ], [ 0.000000e+00, %entry ]
  %.59.052 = phi i64 [ %.123, %B50.endif.endif.endif ], [ %.69, %entry ]
  %.56.051 = phi i64 [ %.127, %B50.endif.endif.endif ], [ %arg.first, %entry ]
  %.123 = add nsw i64 %.59.052, -1
  %.127 = add i64 %.56.051, 1
  %.153 = getelementptr double, ptr %arg.found, i64 %.56.051
  %.154 = load double, ptr %.153, align 8
  %.155 = call contract double @llvm.fabs.f64(double %.154)
  store double 0.000000e+00, ptr %.159, align 8
  %.165 = call i32 @numba.28(ptr nonnull %.159, ptr nonnull %excinfo.1, double %size.2.055, double %.155)
  %.175 = load double, ptr %.159, align 8
  switch i32 %.165, label %B50.if [
    i32 -2, label %B50.endif
    i32 0, label %B50.endif
  ]

B50.if:
  %.173 = icmp sgt i32 %.165, 0
  %.166 = load ptr, ptr %excinfo.1, align 8
  %.174 = select i1 %.173, ptr %.166, ptr undef
  store ptr %.174, ptr %excinfo, align 8
  br label %common.ret

B50.endif:
  %.191 = getelementptr double, ptr %arg.guess, i64 %.56.051
  %.192 = load double, ptr %.191, align 8
  %.193 = fsub contract double %.154, %.192
  %.194 = call contract double @llvm.fabs.f64(double %.193)
  store double 0.000000e+00, ptr %.198, align 8
  %.204 = call i32 @numba.28(ptr nonnull %.198, ptr nonnull %excinfo.2, double %apart.2.054, double %.194)
  %.214 = load double, ptr %.198, align 8
  switch i32 %.204, label %B50.endif.if [
    i32 -2, label %B50.endif.endif
    i32 0, label %B50.endif.endif
  ]

B50.endif.if:
  %.212 = icmp sgt i32 %.204, 0
  %.205 = load ptr, ptr %excinfo.2, align 8
  %.213 = select i1 %.212, ptr %.205, ptr undef
  store ptr %.213, ptr %excinfo, align 8
  br label %common.ret

B50.endif.endif:
  %.230 = getelementptr double, ptr %arg.now, i64 %.56.051
  %.231 = load double, ptr %.230, align 8
  %.232 = fsub contract double %.154, %.231
  %.233 = call contract double @llvm.fabs.f64(double %.232)
  store double 0.000000e+00, ptr %.237, align 8
  %.243 = call i32 @numba.28(ptr nonnull %.237, ptr nonnull %excinfo.3, double %moved.2.053, double %.233)
  switch i32 %.243, label %B50.endif.endif.if [
    i32 -2, label %B50.endif.endif.endif
    i32 0, label %B50.endif.endif.endif
  ]

B50.endif.endif.if:
  %.251 = icmp sgt i32 %.243, 0
  %.244 = load ptr, ptr %excinfo.3, align 8
  %.252 = select i1 %.251, ptr %.244, ptr undef
  store ptr %.252, ptr %excinfo, align 8
  br label %common.ret

B50.endif.endif.endif:
  %.253 = load double, ptr %.237, align 8
  %.114 = icmp sgt i64 %.59.052, 1
  br i1 %.114, label %B48.if, label %B300

B300.if:
  %.294 = icmp sgt i32 %.286, 0
  %.287 = load ptr, ptr %excinfo.4, align 8
  %.295 = select i1 %.294, ptr %.287, ptr undef
  store ptr %.295, ptr %excinfo, align 8
  br label %common.ret

B300.endif:
  %.296 = load double, ptr %.280, align 8
  %.312 = fmul contract double %arg.near, %size.2.0.lcssa
  %.317 = fcmp contract ogt double %.296, %.312
  br i1 %.317, label %B346, label %B350
}

define internal i32 @numba.123(ptr noalias %retptr, ptr noalias %excinfo, double %arg.x) {
entry:
  %.5 = fptosi double %arg.x to i64
  store i64 %.5, ptr %retptr, align 8
  ret i32 0
}

define internal i32 @largest_of.124(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.values) noinline {
entry:
  %.160 = alloca double, align 8
  store double 0.000000e+00, ptr %.160, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.9247.not = icmp slt i64 %arg.n, 1
  br i1 %.9247.not, label %B194, label %B38.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B94 ], [ 0, %B194 ], [ %.166, %B122.if ]
  ret i32 %common.ret.op

B94:
  store double 0x7FF0000000000000, ptr %retptr, align 8
  br label %common.ret

B122:
  %.156 = call contract double @llvm.fabs.f64(double %.136)
  store double 0.000000e+00, ptr %.160, align 8
  %.166 = call i32 @numba.28(ptr nonnull %.160, ptr nonnull %excinfo.1, double %largest.2.050, double %.156)
  switch i32 %.166, label %B122.if [
    i32 -2, label %B122.endif
    i32 0, label %B122.endif
  ]

B194:
  %largest.2.0.lcssa = phi double [ 0.000000e+00, %entry ], [ %.176, %B122.endif ]
  store double %largest.2.0.lcssa, ptr %retptr, align 8
  br label %common.ret

B38.if:
  %largest.2.050 = phi double [ %.176, %B122.endif ], [ 0.000000e+00, %entry ]
  %.34.048 = phi i64 [ %.105, %B122.endif ], [ 0, %entry ]
  %.105 = add nuw nsw i64 %.34.048, 1
  %.135 = getelementptr double, ptr %arg.values, i64 %.34.048
  %.136 = load double, ptr %.135, align 8
  %.137 = fsub contract double %.136, %.136
  %.138 = fcmp contract ord double %.137, 0.000000e+00
  br i1 %.138, label %B122, label %B94

B122.if:
  %.174 = icmp sgt i32 %.166, 0
  %.167 = load ptr, ptr %excinfo.1, align 8
  %.175 = select i1 %.174, ptr %.167, ptr undef
  store ptr %.175, ptr %excinfo, align 8
  br label %common.ret

B122.endif:
  %.176 = load double, ptr %.160, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.105
  br i1 %exitcond.not, label %B194, label %B38.if
}

declare i64 @llvm.smin.i64(i64, i64)

declare i64 @llvm.smax.i64(i64, i64)

declare void @llvm.memset.p0.i64(ptr, i8, i64, i1 immarg)

declare void @llvm.memcpy.p0.p0.i64(ptr noalias, ptr noalias, i64, i1 immarg)
