; made from f4db3abaeb42f54e8c8165c1e12245f099050cda99375e6f3ff7f356502c5c4f
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

define i64 @pair_up(i64 %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @pair_up.8(ptr nonnull %r, ptr nonnull %e, i64 %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5)
  ret i64 0
}

define internal i32 @pair_up.8(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.start, ptr noalias %arg.columns, ptr noalias %arg.partner, ptr noalias %arg.common, ptr noalias %arg.seen) noinline {
entry:
  %.104238.not = icmp slt i64 %arg.n, 1
  br i1 %.104238.not, label %B90.preheader, label %B34.if.preheader

B34.if.preheader:
  %0 = shl nuw i64 %arg.n, 2
  call void @llvm.memset.p0.i64(ptr align 4 %arg.partner, i8 -1, i64 %0, i1 false)
  %1 = shl nuw i64 %arg.n, 2
  call void @llvm.memset.p0.i64(ptr align 4 %arg.common, i8 0, i64 %1, i1 false)
  br label %B90.preheader

B90.preheader:
  %.238256.not = icmp slt i64 %arg.n, 1
  br i1 %.238256.not, label %B656, label %B92.if

B122:
  %.294 = getelementptr i32, ptr %arg.start, i64 %.181.0257
  %.295 = load i32, ptr %.294, align 4
  %.299 = getelementptr i8, ptr %.294, i64 4
  %.300 = load i32, ptr %.299, align 4
  %.337 = sub i32 %.300, %.295
  %.380245.not = icmp slt i32 %.337, 1
  br i1 %.380245.not, label %B406, label %B188.if

B188.loopexit:
  %count.2.2.lcssa = phi i64 [ %count.5.1248, %B188.if ], [ %count.3.3, %B402 ]
  %.380 = icmp sgt i32 %.327.0247, 1
  br i1 %.380, label %B188.if, label %B406

B302:
  %.576 = getelementptr i32, ptr %arg.partner, i64 %.567
  %.577 = load i32, ptr %.576, align 4
  %.579 = icmp slt i32 %.577, 0
  br i1 %.579, label %B326, label %B402

B326:
  %.590 = getelementptr i32, ptr %arg.common, i64 %.567
  %.591 = load i32, ptr %.590, align 4
  %.593 = icmp eq i32 %.591, 0
  br i1 %.593, label %B350, label %B370

B350:
  %.598 = getelementptr i32, ptr %arg.seen, i64 %count.2.2244
  store i32 %.561, ptr %.598, align 4
  %.601 = add nsw i64 %count.2.2244, 1
  br label %B370

B370:
  %count.4.3 = phi i64 [ %.601, %B350 ], [ %count.2.2244, %B326 ]
  %.620 = add i32 %.591, 1
  store i32 %.620, ptr %.590, align 4
  br label %B402

B402:
  %count.3.3 = phi i64 [ %count.4.3, %B370 ], [ %count.2.2244, %B302 ], [ %count.2.2244, %B270.if ]
  %.516 = icmp sgt i32 %.463.0243, 1
  br i1 %.516, label %B270.if, label %B188.loopexit

B406:
  %count.5.1.lcssa = phi i64 [ 0, %B122 ], [ %count.2.2.lcssa, %B188.loopexit ]
  %.744250.not = icmp slt i64 %count.5.1.lcssa, 1
  br i1 %.744250.not, label %B620, label %B446.if.lr.ph

B446.if.lr.ph:
  %.807 = sext i32 %.300 to i64
  %.808 = sext i32 %.295 to i64
  br label %B446.if

B620:
  %best.2.1.lcssa = phi i64 [ -1, %B406 ], [ %best.3.2, %B446.if ]
  %.891 = icmp sgt i64 %best.2.1.lcssa, -1
  br i1 %.891, label %B632, label %B657

B632:
  %.896 = trunc nuw nsw i64 %best.2.1.lcssa to i32
  store i32 %.896, ptr %.281, align 4
  %.902 = trunc i64 %.181.0257 to i32
  %.903 = getelementptr i32, ptr %arg.partner, i64 %best.2.1.lcssa
  store i32 %.902, ptr %.903, align 4
  br label %B657

B656:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B657:
  %exitcond259.not = icmp eq i64 %arg.n, %.251
  br i1 %exitcond259.not, label %B656, label %B92.if

B92.if:
  %.181.0257 = phi i64 [ %.251, %B657 ], [ 0, %B90.preheader ]
  %.251 = add nuw nsw i64 %.181.0257, 1
  %.281 = getelementptr i32, ptr %arg.partner, i64 %.181.0257
  %.282 = load i32, ptr %.281, align 4
  %.284 = icmp sgt i32 %.282, -1
  br i1 %.284, label %B657, label %B122

B188.if:
  %count.5.1248 = phi i64 [ %count.2.2.lcssa, %B188.loopexit ], [ 0, %B122 ]
  %.327.0247 = phi i32 [ %.389, %B188.loopexit ], [ %.337, %B122 ]
  %.324.0246 = phi i32 [ %.393, %B188.loopexit ], [ %.295, %B122 ]
  %.389 = add nsw i32 %.327.0247, -1
  %.393 = add i32 %.324.0246, 1
  %2 = sext i32 %.324.0246 to i64
  %.426 = getelementptr i32, ptr %arg.columns, i64 %2
  %.427 = load i32, ptr %.426, align 4
  %.429 = sext i32 %.427 to i64
  %.430 = getelementptr i32, ptr %arg.start, i64 %.429
  %.431 = load i32, ptr %.430, align 4
  %.435 = getelementptr i8, ptr %.430, i64 4
  %.436 = load i32, ptr %.435, align 4
  %.473 = sub i32 %.436, %.431
  %.516241.not = icmp slt i32 %.473, 1
  br i1 %.516241.not, label %B188.loopexit, label %B270.if

B270.if:
  %count.2.2244 = phi i64 [ %count.3.3, %B402 ], [ %count.5.1248, %B188.if ]
  %.463.0243 = phi i32 [ %.525, %B402 ], [ %.473, %B188.if ]
  %.460.0242 = phi i32 [ %.529, %B402 ], [ %.431, %B188.if ]
  %.525 = add nsw i32 %.463.0243, -1
  %.529 = add i32 %.460.0242, 1
  %3 = sext i32 %.460.0242 to i64
  %.560 = getelementptr i32, ptr %arg.columns, i64 %3
  %.561 = load i32, ptr %.560, align 4
  %.567 = sext i32 %.561 to i64
  %.568 = icmp slt i64 %.181.0257, %.567
  br i1 %.568, label %B302, label %B402

B446.if:
  %most.2.1254 = phi double [ 0.000000e+00, %B446.if.lr.ph ], [ %most.3.2, %B446.if ]
  %best.2.1253 = phi i64 [ -1, %B446.if.lr.ph ], [ %best.3.2, %B446.if ]
  %.688.0251 = phi i64 [ 0, %B446.if.lr.ph ], [ %.757, %B446.if ]
  %.757 = add nuw nsw i64 %.688.0251, 1
  %.793 = getelementptr i32, ptr %arg.seen, i64 %.688.0251
  %.794 = load i32, ptr %.793, align 4
  %.811 = sext i32 %.794 to i64
  %4 = getelementptr i32, ptr %arg.start, i64 %.811
  %.814 = getelementptr i8, ptr %4, i64 4
  %.815 = load i32, ptr %.814, align 4
  %.816 = sext i32 %.815 to i64
  %.822 = load i32, ptr %4, align 4
  %.823 = sext i32 %.822 to i64
  %.828 = getelementptr i32, ptr %arg.common, i64 %.811
  %.829 = load i32, ptr %.828, align 4
  %.830 = sext i32 %.829 to i64
  %5 = add nsw i64 %.807, %.816
  %6 = add nsw i64 %.808, %.823
  %7 = add nsw i64 %6, %.830
  %.831 = sub nsw i64 %5, %7
  %.838 = sitofp i32 %.829 to double
  %.839 = sitofp i64 %.831 to double
  %.843 = fdiv contract double %.838, %.839
  %.849 = fcmp contract ogt double %.843, %most.2.1254
  %best.3.2 = select i1 %.849, i64 %.811, i64 %best.2.1253
  %most.3.2 = select i1 %.849, double %.843, double %most.2.1254
  store i32 0, ptr %.828, align 4
  %exitcond.not = icmp eq i64 %.757, %count.5.1.lcssa
  br i1 %exitcond.not, label %B620, label %B446.if
}

define i64 @elimination_order(i64 %a0, ptr %a1, ptr %a2, i64 %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13) {
  %r = alloca i64, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @elimination_order.9(ptr nonnull %r, ptr nonnull %e, i64 %a0, ptr %a1, ptr %a2, i64 %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13)
  %v = load i64, ptr %r, align 8
  ret i64 %v
}

define internal i32 @elimination_order.9(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.start, ptr noalias %arg.members, i64 %arg.capacity, ptr noalias %arg.order, ptr noalias %arg.at, ptr noalias %arg.count, ptr noalias %arg.room, ptr noalias %arg.pool, ptr noalias %arg.degree, ptr noalias %arg.head, ptr noalias %arg.after, ptr noalias %arg.before, ptr noalias %arg.mark) noinline {
entry:
  %.488 = alloca ptr, align 8
  store ptr null, ptr %.488, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.705 = alloca ptr, align 8
  store ptr null, ptr %.705, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.1038 = alloca i64, align 8
  store i64 0, ptr %.1038, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.1127 = alloca ptr, align 8
  store ptr null, ptr %.1127, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.1178 = alloca ptr, align 8
  store ptr null, ptr %.1178, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.1212 = alloca i64, align 8
  store i64 0, ptr %.1212, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.47 = shl nsw i64 %arg.n, 1
  %.49 = getelementptr i32, ptr %arg.start, i64 %.47
  %.50 = load i32, ptr %.49, align 4
  %.93 = icmp sgt i64 %arg.n, 0
  %storemerge = select i1 %.93, i64 %.47, i64 0
  %.137352 = icmp sgt i64 %storemerge, 0
  br i1 %.137352, label %B62.if.preheader, label %B166

B62.if.preheader:
  %0 = shl nuw i64 %storemerge, 2
  call void @llvm.memset.p0.i64(ptr align 4 %arg.head, i8 -1, i64 %0, i1 false)
  %1 = shl nuw i64 %storemerge, 2
  call void @llvm.memset.p0.i64(ptr align 4 %arg.mark, i8 -1, i64 %1, i1 false)
  %2 = shl nuw i64 %storemerge, 2
  call void @llvm.memcpy.p0.p0.i64(ptr align 4 %arg.at, ptr align 4 %arg.start, i64 %2, i1 false)
  br label %B62.if

B166:
  %.294355.not = icmp slt i32 %.50, 1
  br i1 %.294355.not, label %B224, label %B196.if.preheader

B196.if.preheader:
  %3 = add nsw i32 %.50, -1
  %4 = zext i32 %3 to i64
  %5 = shl nuw nsw i64 %4, 2
  %6 = add nuw nsw i64 %5, 4
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 4 dereferenceable(1) %arg.pool, ptr nonnull align 4 dereferenceable(1) %arg.members, i64 %6, i1 false)
  br label %B224

B224:
  br i1 %.93, label %B254.if.lr.ph, label %B360

B254.if.lr.ph:
  %7 = getelementptr i32, ptr %arg.count, i64 %arg.n
  br label %B254.if

B360:
  %.608371.not = icmp slt i64 %arg.n, 1
  br i1 %.608371.not, label %B932, label %B396.if.lr.ph

B396.if.lr.ph:
  %.518 = sext i32 %.50 to i64
  %8 = getelementptr i32, ptr %arg.count, i64 %arg.n
  br label %B396.if

B394.loopexit:
  %exitcond404.not = icmp eq i64 %arg.n, %.621
  br i1 %exitcond404.not, label %B932, label %B396.if

B424:
  %least.7.1 = phi i64 [ %.667, %B424 ], [ %least.3.0375, %B396.if ]
  %.667 = add nsw i64 %least.7.1, 1
  %.673 = getelementptr i32, ptr %arg.head, i64 %.667
  %.674 = load i32, ptr %.673, align 4
  %.676 = icmp slt i32 %.674, 0
  br i1 %.676, label %B424, label %B458

B458:
  %least.5.2 = phi i64 [ %least.3.0375, %B396.if ], [ %.667, %B424 ]
  %.692 = getelementptr i32, ptr %arg.head, i64 %least.5.2
  %.693 = load i32, ptr %.692, align 4
  store ptr null, ptr %.705, align 8
  %.709 = call i32 @delist.10(ptr nonnull %.705, ptr nonnull %excinfo.2, i32 %.693, ptr %arg.degree, ptr %arg.head, ptr %arg.after, ptr %arg.before)
  switch i32 %.709, label %B458.if [
    i32 -2, label %B458.endif
    i32 0, label %B458.endif
  ]

B552.loopexit:
  %free.2.2.lcssa = phi i64 [ %free.3.1369, %B552.if ], [ %.1052, %B758.endif.endif.endif ]
  %least.6.2.lcssa = phi i64 [ %least.4.1370, %B552.if ], [ %.1226, %B758.endif.endif.endif ]
  br i1 %exitcond403.not, label %B394.loopexit, label %B552.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B748 ], [ 0, %B932 ], [ %.1216, %B758.endif.endif.if ], [ %.1131, %B758.if ], [ %.1042, %B638.if ], [ %.1182, %B758.endif.if ], [ %.709, %B458.if ], [ %.492, %B256.if ]
  ret i32 %common.ret.op

B748:
  store i64 -1, ptr %retptr, align 8
  br label %common.ret

B758:
  store ptr null, ptr %.1127, align 8
  %.1131 = call i32 @delist.10(ptr nonnull %.1127, ptr nonnull %excinfo.4, i32 %.1017, ptr %arg.degree, ptr %arg.head, ptr %arg.after, ptr %arg.before)
  switch i32 %.1131, label %B758.if [
    i32 -2, label %B758.endif
    i32 0, label %B758.endif
  ]

B932:
  store i64 0, ptr %retptr, align 8
  br label %common.ret

B62.if:
  %.79.0353 = phi i64 [ %.150, %B62.if ], [ 0, %B62.if.preheader ]
  %.150 = add nuw nsw i64 %.79.0353, 1
  %.176 = getelementptr i32, ptr %arg.start, i64 %.79.0353
  %.177 = load i32, ptr %.176, align 4
  %.183 = getelementptr i8, ptr %.176, i64 4
  %.184 = load i32, ptr %.183, align 4
  %.190 = sub i32 %.184, %.177
  %.193 = getelementptr i32, ptr %arg.count, i64 %.79.0353
  store i32 %.190, ptr %.193, align 4
  %.197 = getelementptr i32, ptr %arg.room, i64 %.79.0353
  store i32 %.190, ptr %.197, align 4
  %exitcond.not = icmp eq i64 %.150, %storemerge
  br i1 %exitcond.not, label %B166, label %B62.if

B254.if:
  %.371.0359 = phi i64 [ 0, %B254.if.lr.ph ], [ %.440, %B256.endif ]
  %9 = xor i64 %.371.0359, -1
  %.467 = add nsw i64 %arg.n, %9
  %.469 = getelementptr i32, ptr %arg.count, i64 %.467
  %.470 = load i32, ptr %.469, align 4
  %.474 = getelementptr i32, ptr %7, i64 %.467
  %.475 = load i32, ptr %.474, align 4
  %.478 = add i32 %.475, %.470
  %.481 = getelementptr i32, ptr %arg.degree, i64 %.467
  store i32 %.478, ptr %.481, align 4
  store ptr null, ptr %.488, align 8
  %.492 = call i32 @enlist.11(ptr nonnull %.488, ptr nonnull %excinfo.1, i64 %.467, ptr %arg.degree, ptr %arg.head, ptr %arg.after, ptr %arg.before)
  switch i32 %.492, label %B256.if [
    i32 -2, label %B256.endif
    i32 0, label %B256.endif
  ]

B256.if:
  %.500 = icmp sgt i32 %.492, 0
  %.493 = load ptr, ptr %excinfo.1, align 8
  %.501 = select i1 %.500, ptr %.493, ptr undef
  store ptr %.501, ptr %excinfo, align 8
  br label %common.ret

B256.endif:
  %.440 = add nuw nsw i64 %.371.0359, 1
  %exitcond400.not = icmp eq i64 %arg.n, %.440
  br i1 %exitcond400.not, label %B360, label %B254.if

B396.if:
  %least.3.0375 = phi i64 [ 0, %B396.if.lr.ph ], [ %least.6.2.lcssa, %B394.loopexit ]
  %free.4.0374 = phi i64 [ %.518, %B396.if.lr.ph ], [ %free.2.2.lcssa, %B394.loopexit ]
  %.551.0372 = phi i64 [ 0, %B396.if.lr.ph ], [ %.621, %B394.loopexit ]
  %.621 = add nuw nsw i64 %.551.0372, 1
  %.659 = getelementptr i32, ptr %arg.head, i64 %least.3.0375
  %.660 = load i32, ptr %.659, align 4
  %.664 = icmp slt i32 %.660, 0
  br i1 %.664, label %B424, label %B458

B458.if:
  %.717 = icmp sgt i32 %.709, 0
  %.710 = load ptr, ptr %excinfo.2, align 8
  %.718 = select i1 %.717, ptr %.710, ptr undef
  store ptr %.718, ptr %excinfo, align 8
  br label %common.ret

B458.endif:
  %.732 = getelementptr i32, ptr %arg.order, i64 %.551.0372
  store i32 %.693, ptr %.732, align 4
  %.872 = sext i32 %.693 to i64
  br label %B552.if

B552.if:
  %least.4.1370 = phi i64 [ %least.5.2, %B458.endif ], [ %least.6.2.lcssa, %B552.loopexit ]
  %free.3.1369 = phi i64 [ %free.4.0374, %B458.endif ], [ %free.2.2.lcssa, %B552.loopexit ]
  %exitcond403.not = phi i1 [ false, %B458.endif ], [ true, %B552.loopexit ]
  %.759.0367 = phi i64 [ 0, %B458.endif ], [ 1, %B552.loopexit ]
  %.870 = mul nuw nsw i64 %.759.0367, %arg.n
  %.873 = add nsw i64 %.870, %.872
  %.875 = xor i64 %.759.0367, 1
  %.877 = mul nuw nsw i64 %.875, %arg.n
  %.880 = add nsw i64 %.877, %.872
  %.889 = getelementptr i32, ptr %arg.count, i64 %.880
  %.890 = load i32, ptr %.889, align 4
  %.970361.not = icmp slt i32 %.890, 1
  br i1 %.970361.not, label %B552.loopexit, label %B636.if.lr.ph

B636.if.lr.ph:
  %.1010 = getelementptr i32, ptr %arg.at, i64 %.880
  %wide.trip.count = zext nneg i32 %.890 to i64
  br label %B636.if

B636.if:
  %indvars.iv = phi i64 [ 0, %B636.if.lr.ph ], [ %indvars.iv.next, %B758.endif.endif.endif ]
  %least.6.2365 = phi i64 [ %least.4.1370, %B636.if.lr.ph ], [ %.1226, %B758.endif.endif.endif ]
  %free.2.2364 = phi i64 [ %free.3.1369, %B636.if.lr.ph ], [ %.1052, %B758.endif.endif.endif ]
  %indvars.iv.next = add nuw nsw i64 %indvars.iv, 1
  %.1011 = load i32, ptr %.1010, align 4
  %.1012 = sext i32 %.1011 to i64
  %10 = getelementptr i32, ptr %arg.pool, i64 %indvars.iv
  %.1016 = getelementptr i32, ptr %10, i64 %.1012
  %.1017 = load i32, ptr %.1016, align 4
  %.1026 = sext i32 %.1017 to i64
  %.1027 = add nsw i64 %.870, %.1026
  store i64 0, ptr %.1038, align 8
  %.1042 = call i32 @merge.12(ptr nonnull %.1038, ptr nonnull %excinfo.3, i64 %.1027, i64 %.873, i32 %.1017, i32 %.693, i64 %free.2.2364, i64 %arg.capacity, ptr %arg.at, ptr %arg.count, ptr %arg.room, ptr %arg.pool, ptr %arg.mark)
  %.1052 = load i64, ptr %.1038, align 8
  switch i32 %.1042, label %B638.if [
    i32 -2, label %B638.endif
    i32 0, label %B638.endif
  ]

B638.if:
  %.1050 = icmp sgt i32 %.1042, 0
  %.1043 = load ptr, ptr %excinfo.3, align 8
  %.1051 = select i1 %.1050, ptr %.1043, ptr undef
  store ptr %.1051, ptr %excinfo, align 8
  br label %common.ret

B638.endif:
  %.1068 = icmp slt i64 %.1052, 0
  br i1 %.1068, label %B748, label %B758

B758.if:
  %.1139 = icmp sgt i32 %.1131, 0
  %.1132 = load ptr, ptr %excinfo.4, align 8
  %.1140 = select i1 %.1139, ptr %.1132, ptr undef
  store ptr %.1140, ptr %excinfo, align 8
  br label %common.ret

B758.endif:
  %.1154 = getelementptr i32, ptr %arg.count, i64 %.1026
  %.1155 = load i32, ptr %.1154, align 4
  %.1161 = getelementptr i32, ptr %8, i64 %.1026
  %.1162 = load i32, ptr %.1161, align 4
  %.1165 = add i32 %.1162, %.1155
  %.1170 = getelementptr i32, ptr %arg.degree, i64 %.1026
  store i32 %.1165, ptr %.1170, align 4
  store ptr null, ptr %.1178, align 8
  %.1182 = call i32 @enlist.13(ptr nonnull %.1178, ptr nonnull %excinfo.5, i32 %.1017, ptr %arg.degree, ptr %arg.head, ptr %arg.after, ptr %arg.before)
  switch i32 %.1182, label %B758.endif.if [
    i32 -2, label %B758.endif.endif
    i32 0, label %B758.endif.endif
  ]

B758.endif.if:
  %.1190 = icmp sgt i32 %.1182, 0
  %.1183 = load ptr, ptr %excinfo.5, align 8
  %.1191 = select i1 %.1190, ptr %.1183, ptr undef
  store ptr %.1191, ptr %excinfo, align 8
  br label %common.ret

B758.endif.endif:
  %.1206 = load i32, ptr %.1170, align 4
  store i64 0, ptr %.1212, align 8
  %.1216 = call i32 @numba.14(ptr nonnull %.1212, ptr nonnull %excinfo.6, i64 %least.6.2365, i32 %.1206)
  switch i32 %.1216, label %B758.endif.endif.if [
    i32 -2, label %B758.endif.endif.endif
    i32 0, label %B758.endif.endif.endif
  ]

B758.endif.endif.if:
  %.1224 = icmp sgt i32 %.1216, 0
  %.1217 = load ptr, ptr %excinfo.6, align 8
  %.1225 = select i1 %.1224, ptr %.1217, ptr undef
  store ptr %.1225, ptr %excinfo, align 8
  br label %common.ret

B758.endif.endif.endif:
  %.1226 = load i64, ptr %.1212, align 8
  %exitcond402.not = icmp eq i64 %indvars.iv.next, %wide.trip.count
  br i1 %exitcond402.not, label %B552.loopexit, label %B636.if
}

define internal i32 @enlist.11(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.i, ptr noalias %arg.degree, ptr noalias %arg.head, ptr noalias %arg.after, ptr noalias %arg.before) {
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

define internal i32 @delist.10(ptr noalias %retptr, ptr noalias %excinfo, i32 %arg.i, ptr noalias %arg.degree, ptr noalias %arg.head, ptr noalias %arg.after, ptr noalias %arg.before) {
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

define internal i32 @merge.12(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.target, i64 %arg.source, i32 %arg.own, i32 %arg.gone, i64 %arg.free, i64 %arg.capacity, ptr noalias %arg.at, ptr noalias %arg.count, ptr noalias %arg.room, ptr noalias %arg.pool, ptr noalias %arg.mark) noinline {
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

define internal i32 @enlist.13(ptr noalias %retptr, ptr noalias %excinfo, i32 %arg.i, ptr noalias %arg.degree, ptr noalias %arg.head, ptr noalias %arg.after, ptr noalias %arg.before) {
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

define i64 @march(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, i64 %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, ptr %a14, i64 %a15, ptr %a16, ptr %a17, ptr %a18, ptr %a19, i64 %a20, i64 %a21, ptr %a22, ptr %a23, ptr %a24, ptr %a25, ptr %a26, ptr %a27) {
  %r = alloca i64, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @march.20(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, i64 %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, ptr %a14, i64 %a15, ptr %a16, ptr %a17, ptr %a18, ptr %a19, i64 %a20, i64 %a21, ptr %a22, ptr %a23, ptr %a24, ptr %a25, ptr %a26, ptr %a27)
  %v = load i64, ptr %r, align 8
  ret i64 %v
}

define internal i32 @march.20(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.pos, ptr noalias %arg.numbers, ptr noalias %arg.drive_rows, ptr noalias %arg.drive_columns, i64 %arg.blocks, ptr noalias %arg.own, ptr noalias %arg.slots, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.mass, i64 %arg.tested, ptr noalias %arg.powers, ptr noalias %arg.method, ptr noalias %arg.settings, ptr noalias %arg.edges, i64 %arg.edge_count, i64 %arg.max_steps, ptr noalias %arg.y, ptr noalias %arg.Y, ptr noalias %arg.state, ptr noalias %arg.counts, ptr noalias %arg.outputs, ptr noalias %arg.work) noinline {
entry:
  %.391 = alloca double, align 8
  store double 0.000000e+00, ptr %.391, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.436 = alloca ptr, align 8
  store ptr null, ptr %.436, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.474 = alloca ptr, align 8
  store ptr null, ptr %.474, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.508 = alloca ptr, align 8
  store ptr null, ptr %.508, align 8
  %excinfo.4 = alloca ptr, align 8
  store ptr null, ptr %excinfo.4, align 8
  %.542 = alloca ptr, align 8
  store ptr null, ptr %.542, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.872 = alloca ptr, align 8
  store ptr null, ptr %.872, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.903 = alloca i64, align 8
  store i64 0, ptr %.903, align 8
  %excinfo.7 = alloca ptr, align 8
  store ptr null, ptr %excinfo.7, align 8
  %.1069 = alloca ptr, align 8
  store ptr null, ptr %.1069, align 8
  %excinfo.8 = alloca ptr, align 8
  store ptr null, ptr %excinfo.8, align 8
  %.1224 = alloca ptr, align 8
  store ptr null, ptr %.1224, align 8
  %excinfo.9 = alloca ptr, align 8
  store ptr null, ptr %excinfo.9, align 8
  %.1263 = alloca ptr, align 8
  store ptr null, ptr %.1263, align 8
  %excinfo.10 = alloca ptr, align 8
  store ptr null, ptr %excinfo.10, align 8
  %.1292 = alloca ptr, align 8
  store ptr null, ptr %.1292, align 8
  %excinfo.11 = alloca ptr, align 8
  store ptr null, ptr %excinfo.11, align 8
  %.1338 = alloca ptr, align 8
  store ptr null, ptr %.1338, align 8
  %excinfo.12 = alloca ptr, align 8
  store ptr null, ptr %excinfo.12, align 8
  %.1372 = alloca ptr, align 8
  store ptr null, ptr %.1372, align 8
  %excinfo.13 = alloca ptr, align 8
  store ptr null, ptr %excinfo.13, align 8
  %.1409 = alloca ptr, align 8
  store ptr null, ptr %.1409, align 8
  %excinfo.14 = alloca ptr, align 8
  store ptr null, ptr %excinfo.14, align 8
  %.1451 = alloca ptr, align 8
  store ptr null, ptr %.1451, align 8
  %excinfo.15 = alloca ptr, align 8
  store ptr null, ptr %excinfo.15, align 8
  %.1497 = alloca ptr, align 8
  store ptr null, ptr %.1497, align 8
  %excinfo.16 = alloca ptr, align 8
  store ptr null, ptr %excinfo.16, align 8
  %.1542 = alloca ptr, align 8
  store ptr null, ptr %.1542, align 8
  %excinfo.17 = alloca ptr, align 8
  store ptr null, ptr %excinfo.17, align 8
  %.1569 = alloca ptr, align 8
  store ptr null, ptr %.1569, align 8
  %excinfo.18 = alloca ptr, align 8
  store ptr null, ptr %excinfo.18, align 8
  %.1603 = alloca double, align 8
  store double 0.000000e+00, ptr %.1603, align 8
  %excinfo.19 = alloca ptr, align 8
  store ptr null, ptr %excinfo.19, align 8
  %.1638 = alloca double, align 8
  store double 0.000000e+00, ptr %.1638, align 8
  %excinfo.20 = alloca ptr, align 8
  store ptr null, ptr %excinfo.20, align 8
  %.1687 = alloca double, align 8
  store double 0.000000e+00, ptr %.1687, align 8
  %excinfo.21 = alloca ptr, align 8
  store ptr null, ptr %excinfo.21, align 8
  %.1952 = alloca ptr, align 8
  store ptr null, ptr %.1952, align 8
  %excinfo.22 = alloca ptr, align 8
  store ptr null, ptr %excinfo.22, align 8
  %.1998 = alloca double, align 8
  store double 0.000000e+00, ptr %.1998, align 8
  %excinfo.23 = alloca ptr, align 8
  store ptr null, ptr %excinfo.23, align 8
  %.2029 = alloca ptr, align 8
  store ptr null, ptr %.2029, align 8
  %excinfo.24 = alloca ptr, align 8
  store ptr null, ptr %excinfo.24, align 8
  %.2153 = alloca double, align 8
  store double 0.000000e+00, ptr %.2153, align 8
  %excinfo.25 = alloca ptr, align 8
  store ptr null, ptr %excinfo.25, align 8
  %.2195 = alloca double, align 8
  store double 0.000000e+00, ptr %.2195, align 8
  %excinfo.26 = alloca ptr, align 8
  store ptr null, ptr %excinfo.26, align 8
  %.2245 = alloca double, align 8
  store double 0.000000e+00, ptr %.2245, align 8
  %excinfo.27 = alloca ptr, align 8
  store ptr null, ptr %excinfo.27, align 8
  %.2277 = alloca double, align 8
  store double 0.000000e+00, ptr %.2277, align 8
  %excinfo.28 = alloca ptr, align 8
  store ptr null, ptr %excinfo.28, align 8
  %.86 = load i64, ptr %arg.layout, align 8
  %.88 = getelementptr i8, ptr %arg.layout, i64 16
  %.89 = load i64, ptr %.88, align 8
  %.97 = getelementptr i8, ptr %arg.layout, i64 8
  %.98 = load i64, ptr %.97, align 8
  %.110.idx = shl i64 %.86, 6
  %.110 = getelementptr i8, ptr %arg.work, i64 %.110.idx
  %.113.idx = mul i64 %.86, 72
  %.113 = getelementptr i8, ptr %arg.work, i64 %.113.idx
  %.idx = mul i64 %.86, 80
  %0 = getelementptr i8, ptr %arg.work, i64 %.idx
  %.117 = getelementptr i8, ptr %0, i64 8
  %.idx307 = mul i64 %.86, 88
  %1 = getelementptr i8, ptr %arg.work, i64 %.idx307
  %.130 = getelementptr i8, ptr %1, i64 8
  %.idx308 = mul i64 %.86, 96
  %2 = getelementptr i8, ptr %arg.work, i64 %.idx308
  %.134 = getelementptr i8, ptr %2, i64 8
  %.144.idx = shl i64 %arg.blocks, 5
  %.144 = getelementptr i8, ptr %.134, i64 %.144.idx
  %.151.idx = shl i64 %arg.blocks, 4
  %.151 = getelementptr i8, ptr %.144, i64 %.151.idx
  %.157 = getelementptr double, ptr %.151, i64 %.89
  %.164 = getelementptr i8, ptr %arg.layout, i64 24
  %.165 = load i64, ptr %.164, align 8
  %3 = getelementptr double, ptr %.157, i64 %.89
  %4 = getelementptr i8, ptr %3, i64 8
  %.168 = getelementptr double, ptr %4, i64 %.165
  %5 = getelementptr double, ptr %.168, i64 %.98
  %.177 = getelementptr i8, ptr %5, i64 8
  %.182 = getelementptr i8, ptr %arg.layout, i64 48
  %.183 = load i64, ptr %.182, align 8
  %.185 = getelementptr double, ptr %.177, i64 %.183
  %6 = getelementptr double, ptr %arg.edges, i64 %arg.edge_count
  %.192 = getelementptr i8, ptr %6, i64 -8
  %.193 = load double, ptr %.192, align 8
  %.199 = load i64, ptr %arg.counts, align 8
  %.288488.not = icmp slt i64 %arg.max_steps, 1
  br i1 %.288488.not, label %B3550, label %B700.if.lr.ph

B700.if.lr.ph:
  %.100 = add nsw i64 %.98, %.86
  %.330 = getelementptr i8, ptr %arg.state, i64 8
  %.463 = getelementptr double, ptr %arg.Y, i64 %.100
  %storemerge309 = call i64 @llvm.smax.i64(i64 %.86, i64 0)
  %.646477.not = icmp slt i64 %.86, 1
  %.844 = getelementptr i8, ptr %arg.counts, i64 32
  %.854 = getelementptr i8, ptr %arg.method, i64 1344
  %.865 = getelementptr i32, ptr %arg.lu_start, i64 %arg.blocks
  %.928 = getelementptr i8, ptr %arg.counts, i64 8
  %.1327 = getelementptr double, ptr %arg.Y, i64 %.100
  %.1527 = getelementptr i8, ptr %arg.counts, i64 24
  %.1537.idx = mul i64 %.86, 56
  %.1537 = getelementptr i8, ptr %arg.work, i64 %.1537.idx
  %.1594 = getelementptr i8, ptr %arg.settings, i64 8
  %.1991 = getelementptr i8, ptr %arg.state, i64 16
  %.1994 = getelementptr i8, ptr %arg.method, i64 1352
  %.2241 = getelementptr i8, ptr %arg.settings, i64 16
  %.1675 = getelementptr i8, ptr %arg.counts, i64 16
  %.1683 = getelementptr i8, ptr %arg.method, i64 1352
  %.1724 = getelementptr i8, ptr %arg.settings, i64 24
  %.330.promoted = load double, ptr %.330, align 8
  %7 = shl nuw i64 %storemerge309, 3
  %8 = add i64 %arg.edge_count, -1
  br label %B700.if

B798:
  %.376 = fmul contract double %.340, 5.000000e-01
  %.378 = fcmp contract ogt double %.331491, %.376
  br i1 %.378, label %B816, label %B854

B816:
  store double 0.000000e+00, ptr %.391, align 8
  %.397 = call i32 @numba.21(ptr nonnull %.391, ptr nonnull %excinfo.1, double %.331491, double %.376)
  switch i32 %.397, label %B816.endif.if [
    i32 -2, label %B816.endif.endif
    i32 0, label %B816.endif.endif
  ]

B854:
  %h.3.1 = phi double [ %.331491, %B798 ], [ %.407, %B816.endif.endif ], [ %.340, %B700.if ]
  br i1 %fresh.3.0490, label %B1286, label %B858

B858:
  store ptr null, ptr %.436, align 8
  %.440 = call i32 @copy.22(ptr nonnull %.436, ptr nonnull %excinfo.2, i64 %.86, ptr %arg.y, ptr %arg.Y)
  switch i32 %.440, label %B858.if [
    i32 -2, label %B858.endif
    i32 0, label %B858.endif
  ]

B1084:
  %.694 = load i64, ptr %.164, align 8
  %.774480.not = icmp slt i64 %.694, 1
  br i1 %.774480.not, label %B1240, label %B1136.if

B1240:
  %.845 = load i64, ptr %.844, align 8
  %.846 = add nsw i64 %.845, 1
  store i64 %.846, ptr %.844, align 8
  br label %B1286

B1286:
  %.855 = load double, ptr %.854, align 8
  %.857 = fmul contract double %h.3.1, %.855
  %.861 = fdiv contract double 1.000000e+00, %.857
  %.866 = load i32, ptr %.865, align 4
  store ptr null, ptr %.872, align 8
  %.876 = call i32 @lu_fill.23(ptr nonnull %.872, ptr nonnull %excinfo.6, i64 %.86, i32 %.866, ptr %.157, ptr %arg.own, ptr %arg.mass, double %.861, ptr %.151)
  switch i32 %.876, label %B1286.endif.if [
    i32 -2, label %B1286.endif.endif
    i32 0, label %B1286.endif.endif
  ]

B1566:
  store ptr null, ptr %.1069, align 8
  %.1073 = call i32 @copy.22(ptr nonnull %.1069, ptr nonnull %excinfo.8, i64 %.86, ptr %arg.y, ptr %.110)
  switch i32 %.1073, label %B1566.if [
    i32 -2, label %B1566.endif
    i32 0, label %B1566.endif
  ]

B1732:
  %.1256 = add nsw i64 %.964.0486, -1
  %.1258 = mul nsw i64 %.1256, %.86
  %.1260 = getelementptr double, ptr %arg.work, i64 %.1258
  store ptr null, ptr %.1263, align 8
  %.1267 = call i32 @add_scaled.24(ptr nonnull %.1263, ptr nonnull %excinfo.10, i64 %.86, double 1.000000e+00, ptr %.1260, ptr %.110)
  switch i32 %.1267, label %B1732.if [
    i32 -2, label %B1808
    i32 0, label %B1808
  ]

B1808:
  store ptr null, ptr %.1292, align 8
  %.1296 = call i32 @copy.22(ptr nonnull %.1292, ptr nonnull %excinfo.11, i64 %.86, ptr %.110, ptr %arg.Y)
  switch i32 %.1296, label %B1808.if [
    i32 -2, label %B1808.endif
    i32 0, label %B1808.endif
  ]

B2126:
  store ptr null, ptr %.1451, align 8
  %.1455 = call i32 @add_scaled.24(ptr nonnull %.1451, ptr nonnull %excinfo.15, i64 %.86, double %.1439, ptr %.130, ptr %.113)
  switch i32 %.1455, label %B2126.if [
    i32 -2, label %B2162
    i32 0, label %B2162
  ]

B2162:
  %.1482 = mul nsw i64 %.964.0486, %.86
  %.1486 = getelementptr double, ptr %arg.work, i64 %.1482
  store ptr null, ptr %.1497, align 8
  %.1501 = call i32 @lu_solve.19(ptr nonnull %.1497, ptr nonnull %excinfo.16, i64 %.86, ptr %arg.slots, i64 %arg.blocks, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %.151, ptr %.113, ptr %.1486, ptr %.144)
  switch i32 %.1501, label %B2162.if [
    i32 -2, label %B2162.endif
    i32 0, label %B2162.endif
  ]

B2252:
  %.1528 = load i64, ptr %.1527, align 8
  %.1529 = add nsw i64 %.1528, 8
  store i64 %.1529, ptr %.1527, align 8
  store ptr null, ptr %.1542, align 8
  %.1546 = call i32 @copy.22(ptr nonnull %.1542, ptr nonnull %excinfo.17, i64 %.86, ptr %.110, ptr %.117)
  switch i32 %.1546, label %B2252.if [
    i32 -2, label %B2252.endif
    i32 0, label %B2252.endif
  ]

B2554:
  %error.2.1 = phi double [ %.1652, %B2252.endif.endif.endif.endif.endif ], [ 0x7FF0000000000000, %B1286.endif.endif.endif ]
  %.1666 = fcmp contract ugt double %error.2.1, 1.000000e+00
  br i1 %.1666, label %B2566, label %B2766

B2566:
  %.1676 = load i64, ptr %.1675, align 8
  %.1677 = add nsw i64 %.1676, 1
  store i64 %.1677, ptr %.1675, align 8
  %.1684 = load double, ptr %.1683, align 8
  store double 0.000000e+00, ptr %.1687, align 8
  %.1691 = call i32 @step_factor.25(ptr nonnull %.1687, ptr nonnull %excinfo.21, double %error.2.1, double 1.000000e+00, double %.1684, ptr %arg.settings)
  switch i32 %.1691, label %B2566.if [
    i32 -2, label %B2566.endif
    i32 0, label %B2566.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ 0, %B2744 ], [ 0, %B3550 ], [ %.2283, %B3418.endif.if ], [ %.2251, %B3418.if ], [ %.397, %B816.endif.if ], [ %.440, %B858.if ], [ %.478, %B858.endif.if ], [ %.512, %B858.endif.endif.if ], [ %.2201, %B3290.endif.endif.if ], [ %.2159, %B3290.if ], [ %.546, %B858.endif.endif.endif.if ], [ %.876, %B1286.endif.if ], [ 0, %B3290.endif.endif.endif ], [ %.907, %B1286.endif.endif.if ], [ %.2033, %B3152.endif.if ], [ %.1073, %B1566.if ], [ %.1228, %B1632.if ], [ %.1267, %B1732.if ], [ %.1296, %B1808.if ], [ %.1342, %B1808.endif.if ], [ %.1376, %B1808.endif.endif.if ], [ %.1413, %B1808.endif.endif.endif.if ], [ %.1455, %B2126.if ], [ %.1501, %B2162.if ], [ %.1546, %B2252.if ], [ %.1573, %B2252.endif.if ], [ %.1609, %B2252.endif.endif.endif.if ], [ %.1642, %B2252.endif.endif.endif.endif.if ], [ %.1691, %B2566.if ], [ %.1956, %B2938.if ], [ %.2002, %B3152.if ]
  ret i32 %common.ret.op

B2744:
  store i64 2, ptr %retptr, align 8
  br label %common.ret

B2766:
  %.1831 = fadd contract double %.328, %h.3.1
  %until.2.1 = select i1 %.347, double %.193, double %.1831
  %.1843 = load i64, ptr %arg.counts, align 8
  %.1853 = icmp slt i64 %.1843, %arg.edge_count
  br i1 %.1853, label %B2822, label %B2904

B2822:
  %.1864 = getelementptr double, ptr %arg.edges, i64 %.1843
  %.1865 = load double, ptr %.1864, align 8
  %.1869 = fmul contract double %until.2.1, 0x3FF0000000000005
  %.1870 = fcmp contract ugt double %.1865, %.1869
  br i1 %.1870, label %B2904, label %B2852

B2852:
  %stop.2.1 = phi i64 [ %.1876, %B2874 ], [ %.1843, %B2822 ]
  %exitcond641.not = icmp eq i64 %stop.2.1, %8
  br i1 %exitcond641.not, label %B2904, label %B2874

B2874:
  %.1876 = add nsw i64 %stop.2.1, 1
  %.1897 = getelementptr double, ptr %arg.edges, i64 %.1876
  %.1898 = load double, ptr %.1897, align 8
  %.1903 = fcmp contract ugt double %.1898, %.1869
  br i1 %.1903, label %B2904, label %B2852

B2904:
  %stop.3.2 = phi i64 [ %.1843, %B2822 ], [ %.1843, %B2766 ], [ %arg.edge_count, %B2852 ], [ %.1876, %B2874 ]
  %.1920 = icmp sgt i64 %stop.3.2, %.1843
  br i1 %.1920, label %B2938, label %B3152

B2938:
  %.1927 = getelementptr double, ptr %arg.edges, i64 %.1843
  %.1932 = sub nsw i64 %stop.3.2, %.1843
  %.1937 = sub nsw i64 %.1843, %.199
  %.1939 = mul nsw i64 %.1937, %.86
  %.1941 = getelementptr double, ptr %arg.outputs, i64 %.1939
  store ptr null, ptr %.1952, align 8
  %.1956 = call i32 @dense_output.26(ptr nonnull %.1952, ptr nonnull %excinfo.22, i64 %.86, ptr %arg.y, ptr %.117, ptr %arg.work, ptr %arg.method, double %.328, double %until.2.1, ptr %.1927, i64 %.1932, ptr %.1941, ptr %.113, ptr %.134, ptr %.144)
  switch i32 %.1956, label %B2938.if [
    i32 -2, label %B2938.endif
    i32 0, label %B2938.endif
  ]

B3152:
  %.1992 = load double, ptr %.1991, align 8
  %.1995 = load double, ptr %.1994, align 8
  store double 0.000000e+00, ptr %.1998, align 8
  %.2002 = call i32 @step_factor.25(ptr nonnull %.1998, ptr nonnull %excinfo.23, double %error.2.1, double %.1992, double %.1995, ptr %arg.settings)
  %.2012 = load double, ptr %.1998, align 8
  switch i32 %.2002, label %B3152.if [
    i32 -2, label %B3152.endif
    i32 0, label %B3152.endif
  ]

B3290:
  store double 0.000000e+00, ptr %.2153, align 8
  %.2159 = call i32 @numba.27(ptr nonnull %.2153, ptr nonnull %excinfo.25, double %.331491, double %h.3.1)
  %.2169 = load double, ptr %.2153, align 8
  switch i32 %.2159, label %B3290.if [
    i32 -2, label %B3290.endif
    i32 0, label %B3290.endif
  ]

B3418:
  %.2235 = fmul contract double %h.3.1, %.2012
  %.2242 = load double, ptr %.2241, align 8
  store double 0.000000e+00, ptr %.2245, align 8
  %.2251 = call i32 @numba.21(ptr nonnull %.2245, ptr nonnull %excinfo.27, double %.2235, double %.2242)
  switch i32 %.2251, label %B3418.if [
    i32 -2, label %B3418.endif
    i32 0, label %B3418.endif
  ]

B3550:
  store i64 1, ptr %retptr, align 8
  br label %common.ret

B3551:
  %.331492 = phi double [ %.1714, %B2566.endif ], [ %.2261, %B3418.endif.endif ]
  %.288 = icmp sgt i64 %.232.0489, 1
  br i1 %.288, label %B700.if, label %B3550

B700.if:
  %.331491 = phi double [ %.330.promoted, %B700.if.lr.ph ], [ %.331492, %B3551 ]
  %fresh.3.0490 = phi i1 [ false, %B700.if.lr.ph ], [ %.1666, %B3551 ]
  %.232.0489 = phi i64 [ %arg.max_steps, %B700.if.lr.ph ], [ %.297, %B3551 ]
  %.297 = add nsw i64 %.232.0489, -1
  %.328 = load double, ptr %arg.state, align 8
  %.340 = fsub contract double %.193, %.328
  %.345 = fmul contract double %.340, 0x3FEFFFFFFF768FA1
  %.347 = fcmp contract oge double %.331491, %.345
  br i1 %.347, label %B854, label %B798

B816.endif.if:
  %.405 = icmp sgt i32 %.397, 0
  %.398 = load ptr, ptr %excinfo.1, align 8
  %.406 = select i1 %.405, ptr %.398, ptr undef
  store ptr %.406, ptr %excinfo, align 8
  br label %common.ret

B816.endif.endif:
  %.407 = load double, ptr %.391, align 8
  br label %B854

B858.if:
  %.448 = icmp sgt i32 %.440, 0
  %.441 = load ptr, ptr %excinfo.2, align 8
  %.449 = select i1 %.448, ptr %.441, ptr undef
  store ptr %.449, ptr %excinfo, align 8
  br label %common.ret

B858.endif:
  store double %.328, ptr %.463, align 8
  store ptr null, ptr %.474, align 8
  %.478 = call i32 @drive.6(ptr nonnull %.474, ptr nonnull %excinfo.3, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.177, ptr %.185)
  switch i32 %.478, label %B858.endif.if [
    i32 -2, label %B858.endif.endif
    i32 0, label %B858.endif.endif
  ]

B858.endif.if:
  %.486 = icmp sgt i32 %.478, 0
  %.479 = load ptr, ptr %excinfo.3, align 8
  %.487 = select i1 %.486, ptr %.479, ptr undef
  store ptr %.487, ptr %excinfo, align 8
  br label %common.ret

B858.endif.endif:
  store ptr null, ptr %.508, align 8
  %.512 = call i32 @jacobian.4(ptr nonnull %.508, ptr nonnull %excinfo.4, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.pos, ptr %arg.numbers, ptr %arg.Y, ptr %.157, ptr %.177, ptr %.185)
  switch i32 %.512, label %B858.endif.endif.if [
    i32 -2, label %B858.endif.endif.endif
    i32 0, label %B858.endif.endif.endif
  ]

B858.endif.endif.if:
  %.520 = icmp sgt i32 %.512, 0
  %.513 = load ptr, ptr %excinfo.4, align 8
  %.521 = select i1 %.520, ptr %.513, ptr undef
  store ptr %.521, ptr %excinfo, align 8
  br label %common.ret

B858.endif.endif.endif:
  store ptr null, ptr %.542, align 8
  %.546 = call i32 @drive_rates.7(ptr nonnull %.542, ptr nonnull %excinfo.5, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.168, ptr %.177, ptr %.185)
  switch i32 %.546, label %B858.endif.endif.endif.if [
    i32 -2, label %B858.endif.endif.endif.endif
    i32 0, label %B858.endif.endif.endif.endif
  ]

B858.endif.endif.endif.if:
  %.554 = icmp sgt i32 %.546, 0
  %.547 = load ptr, ptr %excinfo.5, align 8
  %.555 = select i1 %.554, ptr %.547, ptr undef
  store ptr %.555, ptr %excinfo, align 8
  br label %common.ret

B858.endif.endif.endif.endif:
  br i1 %.646477.not, label %B1084, label %B1068.if.preheader

B1068.if.preheader:
  call void @llvm.memset.p0.i64(ptr align 8 %.130, i8 0, i64 %7, i1 false)
  br label %B1084

B1136.if:
  %.718.0481 = phi i64 [ %.787, %B1136.if ], [ 0, %B1084 ]
  %.787 = add nuw nsw i64 %.718.0481, 1
  %.813 = getelementptr i32, ptr %arg.drive_rows, i64 %.718.0481
  %.814 = load i32, ptr %.813, align 4
  %.816 = sext i32 %.814 to i64
  %.817 = getelementptr double, ptr %.130, i64 %.816
  %.818 = load double, ptr %.817, align 8
  %.823 = getelementptr double, ptr %4, i64 %.718.0481
  %.824 = load double, ptr %.823, align 8
  %.826 = getelementptr i32, ptr %arg.drive_columns, i64 %.718.0481
  %.827 = load i32, ptr %.826, align 4
  %.829 = sext i32 %.827 to i64
  %.830 = getelementptr double, ptr %.168, i64 %.829
  %.831 = load double, ptr %.830, align 8
  %.832 = fmul contract double %.824, %.831
  %.833 = fadd contract double %.818, %.832
  store double %.833, ptr %.817, align 8
  %exitcond.not = icmp eq i64 %.694, %.787
  br i1 %exitcond.not, label %B1240, label %B1136.if

B1286.endif.if:
  %.884 = icmp sgt i32 %.876, 0
  %.877 = load ptr, ptr %excinfo.6, align 8
  %.885 = select i1 %.884, ptr %.877, ptr undef
  store ptr %.885, ptr %excinfo, align 8
  br label %common.ret

B1286.endif.endif:
  store i64 0, ptr %.903, align 8
  %.907 = call i32 @lu_factor.17(ptr nonnull %.903, ptr nonnull %excinfo.7, i64 %arg.blocks, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %.151, ptr %.134)
  switch i32 %.907, label %B1286.endif.endif.if [
    i32 -2, label %B1286.endif.endif.endif
    i32 0, label %B1286.endif.endif.endif
  ]

B1286.endif.endif.if:
  %.915 = icmp sgt i32 %.907, 0
  %.908 = load ptr, ptr %excinfo.7, align 8
  %.916 = select i1 %.915, ptr %.908, ptr undef
  store ptr %.916, ptr %excinfo, align 8
  br label %common.ret

B1286.endif.endif.endif:
  %.917 = load i64, ptr %.903, align 8
  %.929 = load i64, ptr %.928, align 8
  %.930 = add nsw i64 %.929, 1
  store i64 %.930, ptr %.928, align 8
  %.937 = icmp eq i64 %.917, 0
  br i1 %.937, label %B1540.if, label %B2554

B1540.if:
  %.964.0486 = phi i64 [ %.1034, %B2162.endif ], [ 0, %B1286.endif.endif.endif ]
  %.1034 = add nuw nsw i64 %.964.0486, 1
  %.1063 = icmp samesign ult i64 %.964.0486, 6
  br i1 %.1063, label %B1566, label %B1732

B1566.if:
  %.1081 = icmp sgt i32 %.1073, 0
  %.1074 = load ptr, ptr %excinfo.8, align 8
  %.1082 = select i1 %.1081, ptr %.1074, ptr undef
  store ptr %.1082, ptr %excinfo, align 8
  br label %common.ret

B1566.endif:
  %.1173483.not = icmp eq i64 %.964.0486, 0
  br i1 %.1173483.not, label %B1808, label %B1630.if.lr.ph

B1630.if.lr.ph:
  %.idx313 = shl nuw nsw i64 %.964.0486, 6
  %9 = getelementptr i8, ptr %arg.method, i64 %.idx313
  br label %B1630.if

B1630.if:
  %.1117.0484 = phi i64 [ 0, %B1630.if.lr.ph ], [ %.1186, %B1632.endif ]
  %.1216 = getelementptr double, ptr %9, i64 %.1117.0484
  %.1217 = load double, ptr %.1216, align 8
  %.1219 = mul nsw i64 %.1117.0484, %.86
  %.1221 = getelementptr double, ptr %arg.work, i64 %.1219
  store ptr null, ptr %.1224, align 8
  %.1228 = call i32 @add_scaled.24(ptr nonnull %.1224, ptr nonnull %excinfo.9, i64 %.86, double %.1217, ptr %.1221, ptr %.110)
  switch i32 %.1228, label %B1632.if [
    i32 -2, label %B1632.endif
    i32 0, label %B1632.endif
  ]

B1632.if:
  %.1236 = icmp sgt i32 %.1228, 0
  %.1229 = load ptr, ptr %excinfo.9, align 8
  %.1237 = select i1 %.1236, ptr %.1229, ptr undef
  store ptr %.1237, ptr %excinfo, align 8
  br label %common.ret

B1632.endif:
  %.1186 = add nuw nsw i64 %.1117.0484, 1
  %exitcond639.not = icmp eq i64 %.1186, %.964.0486
  br i1 %exitcond639.not, label %B1808, label %B1630.if

B1732.if:
  %.1275 = icmp sgt i32 %.1267, 0
  %.1268 = load ptr, ptr %excinfo.10, align 8
  %.1276 = select i1 %.1275, ptr %.1268, ptr undef
  store ptr %.1276, ptr %excinfo, align 8
  br label %common.ret

B1808.if:
  %.1304 = icmp sgt i32 %.1296, 0
  %.1297 = load ptr, ptr %excinfo.11, align 8
  %.1305 = select i1 %.1304, ptr %.1297, ptr undef
  store ptr %.1305, ptr %excinfo, align 8
  br label %common.ret

B1808.endif:
  %10 = getelementptr double, ptr %arg.method, i64 %.964.0486
  %.1319 = getelementptr i8, ptr %10, i64 1024
  %.1320 = load double, ptr %.1319, align 8
  %.1322 = fmul contract double %h.3.1, %.1320
  %.1324 = fadd contract double %.328, %.1322
  store double %.1324, ptr %.1327, align 8
  store ptr null, ptr %.1338, align 8
  %.1342 = call i32 @drive.6(ptr nonnull %.1338, ptr nonnull %excinfo.12, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.177, ptr %.185)
  switch i32 %.1342, label %B1808.endif.if [
    i32 -2, label %B1808.endif.endif
    i32 0, label %B1808.endif.endif
  ]

B1808.endif.if:
  %.1350 = icmp sgt i32 %.1342, 0
  %.1343 = load ptr, ptr %excinfo.12, align 8
  %.1351 = select i1 %.1350, ptr %.1343, ptr undef
  store ptr %.1351, ptr %excinfo, align 8
  br label %common.ret

B1808.endif.endif:
  store ptr null, ptr %.1372, align 8
  %.1376 = call i32 @residual.0(ptr nonnull %.1372, ptr nonnull %excinfo.13, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.113, ptr %.177, ptr %.185)
  switch i32 %.1376, label %B1808.endif.endif.if [
    i32 -2, label %B1808.endif.endif.endif
    i32 0, label %B1808.endif.endif.endif
  ]

B1808.endif.endif.if:
  %.1384 = icmp sgt i32 %.1376, 0
  %.1377 = load ptr, ptr %excinfo.13, align 8
  %.1385 = select i1 %.1384, ptr %.1377, ptr undef
  store ptr %.1385, ptr %excinfo, align 8
  br label %common.ret

B1808.endif.endif.endif:
  %.idx312 = shl i64 %.964.0486, 6
  %11 = getelementptr i8, ptr %arg.method, i64 %.idx312
  %.1401 = getelementptr i8, ptr %11, i64 512
  store ptr null, ptr %.1409, align 8
  %.1413 = call i32 @combine.28(ptr nonnull %.1409, ptr nonnull %excinfo.14, i64 %.86, i64 %.964.0486, ptr %.1401, double %h.3.1, ptr %arg.mass, ptr %arg.work, ptr %.113, ptr %.117)
  switch i32 %.1413, label %B1808.endif.endif.endif.if [
    i32 -2, label %B1808.endif.endif.endif.endif
    i32 0, label %B1808.endif.endif.endif.endif
  ]

B1808.endif.endif.endif.if:
  %.1421 = icmp sgt i32 %.1413, 0
  %.1414 = load ptr, ptr %excinfo.14, align 8
  %.1422 = select i1 %.1421, ptr %.1414, ptr undef
  store ptr %.1422, ptr %excinfo, align 8
  br label %common.ret

B1808.endif.endif.endif.endif:
  %.1436 = getelementptr i8, ptr %10, i64 1088
  %.1437 = load double, ptr %.1436, align 8
  %.1439 = fmul contract double %h.3.1, %.1437
  %.1444 = fcmp contract une double %.1439, 0.000000e+00
  br i1 %.1444, label %B2126, label %B2162

B2126.if:
  %.1463 = icmp sgt i32 %.1455, 0
  %.1456 = load ptr, ptr %excinfo.15, align 8
  %.1464 = select i1 %.1463, ptr %.1456, ptr undef
  store ptr %.1464, ptr %excinfo, align 8
  br label %common.ret

B2162.if:
  %.1509 = icmp sgt i32 %.1501, 0
  %.1502 = load ptr, ptr %excinfo.16, align 8
  %.1510 = select i1 %.1509, ptr %.1502, ptr undef
  store ptr %.1510, ptr %excinfo, align 8
  br label %common.ret

B2162.endif:
  %exitcond640.not = icmp eq i64 %.1034, 8
  br i1 %exitcond640.not, label %B2252, label %B1540.if

B2252.if:
  %.1554 = icmp sgt i32 %.1546, 0
  %.1547 = load ptr, ptr %excinfo.17, align 8
  %.1555 = select i1 %.1554, ptr %.1547, ptr undef
  store ptr %.1555, ptr %excinfo, align 8
  br label %common.ret

B2252.endif:
  store ptr null, ptr %.1569, align 8
  %.1573 = call i32 @add_scaled.24(ptr nonnull %.1569, ptr nonnull %excinfo.18, i64 %.86, double 1.000000e+00, ptr %.1537, ptr %.117)
  switch i32 %.1573, label %B2252.endif.if [
    i32 -2, label %B2252.endif.endif
    i32 0, label %B2252.endif.endif
  ]

B2252.endif.if:
  %.1581 = icmp sgt i32 %.1573, 0
  %.1574 = load ptr, ptr %excinfo.18, align 8
  %.1582 = select i1 %.1581, ptr %.1574, ptr undef
  store ptr %.1582, ptr %excinfo, align 8
  br label %common.ret

B2252.endif.endif:
  %.1595 = load double, ptr %.1594, align 8
  %.1600 = fdiv contract double %h.3.1, %.1595
  store double 0.000000e+00, ptr %.1603, align 8
  %.1609 = call i32 @numba.21(ptr nonnull %.1603, ptr nonnull %excinfo.19, double 1.000000e+00, double %.1600)
  switch i32 %.1609, label %B2252.endif.endif.endif.if [
    i32 -2, label %B2252.endif.endif.endif.endif
    i32 0, label %B2252.endif.endif.endif.endif
  ]

B2252.endif.endif.endif.if:
  %.1617 = icmp sgt i32 %.1609, 0
  %.1610 = load ptr, ptr %excinfo.19, align 8
  %.1618 = select i1 %.1617, ptr %.1610, ptr undef
  store ptr %.1618, ptr %excinfo, align 8
  br label %common.ret

B2252.endif.endif.endif.endif:
  %.1619 = load double, ptr %.1603, align 8
  %.1632 = load double, ptr %arg.settings, align 8
  store double 0.000000e+00, ptr %.1638, align 8
  %.1642 = call i32 @step_error.29(ptr nonnull %.1638, ptr nonnull %excinfo.20, i64 %.86, i64 %arg.tested, ptr %arg.y, ptr %.117, ptr %.1537, ptr %arg.powers, double %.1619, double %.1632)
  switch i32 %.1642, label %B2252.endif.endif.endif.endif.if [
    i32 -2, label %B2252.endif.endif.endif.endif.endif
    i32 0, label %B2252.endif.endif.endif.endif.endif
  ]

B2252.endif.endif.endif.endif.if:
  %.1650 = icmp sgt i32 %.1642, 0
  %.1643 = load ptr, ptr %excinfo.20, align 8
  %.1651 = select i1 %.1650, ptr %.1643, ptr undef
  store ptr %.1651, ptr %excinfo, align 8
  br label %common.ret

B2252.endif.endif.endif.endif.endif:
  %.1652 = load double, ptr %.1638, align 8
  br label %B2554

B2566.if:
  %.1699 = icmp sgt i32 %.1691, 0
  %.1692 = load ptr, ptr %excinfo.21, align 8
  %.1700 = select i1 %.1699, ptr %.1692, ptr undef
  store ptr %.1700, ptr %excinfo, align 8
  br label %common.ret

B2566.endif:
  %.1701 = load double, ptr %.1687, align 8
  %.1714 = fmul contract double %h.3.1, %.1701
  store double %.1714, ptr %.330, align 8
  %.1725 = load double, ptr %.1724, align 8
  %.1726 = fcmp contract olt double %.1714, %.1725
  br i1 %.1726, label %B2744, label %B3551

B2938.if:
  %.1964 = icmp sgt i32 %.1956, 0
  %.1957 = load ptr, ptr %excinfo.22, align 8
  %.1965 = select i1 %.1964, ptr %.1957, ptr undef
  store ptr %.1965, ptr %excinfo, align 8
  br label %common.ret

B2938.endif:
  store i64 %stop.3.2, ptr %arg.counts, align 8
  br label %B3152

B3152.if:
  %.2010 = icmp sgt i32 %.2002, 0
  %.2003 = load ptr, ptr %excinfo.23, align 8
  %.2011 = select i1 %.2010, ptr %.2003, ptr undef
  store ptr %.2011, ptr %excinfo, align 8
  br label %common.ret

B3152.endif:
  store ptr null, ptr %.2029, align 8
  %.2033 = call i32 @copy.22(ptr nonnull %.2029, ptr nonnull %excinfo.24, i64 %.86, ptr %.117, ptr %arg.y)
  switch i32 %.2033, label %B3152.endif.if [
    i32 -2, label %B3152.endif.endif
    i32 0, label %B3152.endif.endif
  ]

B3152.endif.if:
  %.2041 = icmp sgt i32 %.2033, 0
  %.2034 = load ptr, ptr %excinfo.24, align 8
  %.2042 = select i1 %.2041, ptr %.2034, ptr undef
  store ptr %.2042, ptr %excinfo, align 8
  br label %common.ret

B3152.endif.endif:
  store double %until.2.1, ptr %arg.state, align 8
  br i1 %.347, label %B3290, label %B3418

B3290.if:
  %.2167 = icmp sgt i32 %.2159, 0
  %.2160 = load ptr, ptr %excinfo.25, align 8
  %.2168 = select i1 %.2167, ptr %.2160, ptr undef
  store ptr %.2168, ptr %excinfo, align 8
  br label %common.ret

B3290.endif:
  %.2184 = getelementptr i8, ptr %arg.settings, i64 32
  %.2185 = load double, ptr %.2184, align 8
  %.2191 = fdiv contract double 1.000000e+00, %.2185
  store double 0.000000e+00, ptr %.2195, align 8
  %.2201 = call i32 @numba.21(ptr nonnull %.2195, ptr nonnull %excinfo.26, double %.2012, double %.2191)
  switch i32 %.2201, label %B3290.endif.endif.if [
    i32 -2, label %B3290.endif.endif.endif
    i32 0, label %B3290.endif.endif.endif
  ]

B3290.endif.endif.if:
  %.2209 = icmp sgt i32 %.2201, 0
  %.2202 = load ptr, ptr %excinfo.26, align 8
  %.2210 = select i1 %.2209, ptr %.2202, ptr undef
  store ptr %.2210, ptr %excinfo, align 8
  br label %common.ret

B3290.endif.endif.endif:
  %.2211 = load double, ptr %.2195, align 8
  %.2223 = fmul contract double %.2169, %.2211
  store double %.2223, ptr %.330, align 8
  store i64 0, ptr %retptr, align 8
  br label %common.ret

B3418.if:
  %.2259 = icmp sgt i32 %.2251, 0
  %.2252 = load ptr, ptr %excinfo.27, align 8
  %.2260 = select i1 %.2259, ptr %.2252, ptr undef
  store ptr %.2260, ptr %excinfo, align 8
  br label %common.ret

B3418.endif:
  %.2261 = load double, ptr %.2245, align 8
  store double %.2261, ptr %.330, align 8
  store double 0.000000e+00, ptr %.2277, align 8
  %.2283 = call i32 @numba.27(ptr nonnull %.2277, ptr nonnull %excinfo.28, double %error.2.1, double 1.000000e-04)
  switch i32 %.2283, label %B3418.endif.if [
    i32 -2, label %B3418.endif.endif
    i32 0, label %B3418.endif.endif
  ]

B3418.endif.if:
  %.2291 = icmp sgt i32 %.2283, 0
  %.2284 = load ptr, ptr %excinfo.28, align 8
  %.2292 = select i1 %.2291, ptr %.2284, ptr undef
  store ptr %.2292, ptr %excinfo, align 8
  br label %common.ret

B3418.endif.endif:
  %.2293 = load double, ptr %.2277, align 8
  store double %.2293, ptr %.1991, align 8
  br label %B3551
}

define internal i32 @copy.22(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y) {
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

define internal i32 @add_scaled.24(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, double %arg.factor, ptr noalias %arg.x, ptr noalias %arg.y) {
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
  %.42 = call i32 @numba.27(ptr nonnull %.36, ptr nonnull %excinfo.1, double %arg.error, double 1.000000e-10)
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
  %.138 = call i32 @numba.27(ptr nonnull %.132, ptr nonnull %excinfo.2, double %.126, double %wanted.2.0)
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
  %.592 = call i32 @copy.22(ptr nonnull %.588, ptr nonnull %excinfo.5, i64 %arg.n, ptr %arg.after, ptr %.575)
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
  %.315 = call i32 @add_scaled.24(ptr nonnull %.311, ptr nonnull %excinfo.1, i64 %arg.n, double %.308, ptr %.303, ptr %arg.first)
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
  %.347 = call i32 @add_scaled.24(ptr nonnull %.343, ptr nonnull %excinfo.2, i64 %arg.n, double %.340, ptr %.303, ptr %arg.second)
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
  %.380 = call i32 @add_scaled.24(ptr nonnull %.376, ptr nonnull %excinfo.3, i64 %arg.n, double %.373, ptr %.303, ptr %arg.third)
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

define internal i32 @numba.27(ptr noalias %retptr, ptr noalias %excinfo, double %arg.x.0, double %arg.x.1) {
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

define internal i32 @combine.28(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, i64 %arg.count, ptr noalias %arg.weights, double %arg.h, ptr noalias %arg.mass, ptr noalias %arg.stages, ptr noalias %arg.right, ptr noalias %arg.pull) noinline {
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
  %.311 = call i32 @add_scaled.24(ptr nonnull %.307, ptr nonnull %excinfo.1, i64 %arg.n, double %.300, ptr %.304, ptr %arg.pull)
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

define internal i32 @step_error.29(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, i64 %arg.tested, ptr noalias %arg.y, ptr noalias %arg.after, ptr noalias %arg.apart, ptr noalias %arg.powers, double %arg.lead, double %arg.tolerance) noinline {
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
  %.356 = call i32 @numba.27(ptr nonnull %.350, ptr nonnull %excinfo.1, double %.342, double %.347)
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
  %.430 = call i32 @numba.27(ptr nonnull %.424, ptr nonnull %excinfo.2, double %worst.3.0140, double %error.3.1)
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
  %.630 = call i32 @numba.27(ptr nonnull %.624, ptr nonnull %excinfo.3, double %worst.5.0144, double %.620)
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

declare i64 @llvm.smin.i64(i64, i64)

declare i64 @llvm.smax.i64(i64, i64)

declare void @llvm.memset.p0.i64(ptr, i8, i64, i1 immarg)

declare void @llvm.memcpy.p0.p0.i64(ptr noalias, ptr noalias, i64, i1 immarg)
