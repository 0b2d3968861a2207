; made from f40389db67662e6802027b415253b0d6a5d1b56cc9e5e8489e87eeefde3138b4
define i64 @residual(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @residual.0(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8)
  ret i64 0
}

define internal i32 @residual.0(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.numbers, ptr noalias %arg.Y, ptr noalias %arg.r, ptr noalias %arg.local, ptr noalias %arg.out) noinline {
entry:
  %.432 = alloca ptr, align 8
  store ptr null, ptr %.432, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.470 = alloca ptr, align 8
  store ptr null, ptr %.470, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.33 = load i64, ptr %arg.layout, align 8
  %.116116 = icmp sgt i64 %.33, -1
  br i1 %.116116, label %B62.if.preheader, label %B78

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
  %.244122.not = icmp slt i64 %.164, 1
  br i1 %.244122.not, label %B454, label %B130.if

B130.loopexit:
  %exitcond128.not = icmp eq i64 %.164, %.257
  br i1 %exitcond128.not, label %B454, label %B130.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B454 ], [ %.474, %B296.endif.if ], [ %.436, %B296.if ]
  ret i32 %common.ret.op

B454:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B130.if:
  %.188.0123 = phi i64 [ %.257, %B130.loopexit ], [ 0, %B78 ]
  %.257 = add nuw nsw i64 %.188.0123, 1
  %3 = mul nuw nsw i64 %.188.0123, 11
  %4 = add nuw nsw i64 %3, 8
  %5 = getelementptr i64, ptr %arg.layout, i64 %4
  %.290 = getelementptr i8, ptr %5, i64 32
  %.291 = load i64, ptr %.290, align 8
  %.295 = getelementptr i8, ptr %5, i64 8
  %.296 = load i64, ptr %.295, align 8
  %.297 = mul nsw i64 %.296, %.291
  %.305 = load i64, ptr %5, align 8
  %.385119.not = icmp slt i64 %.305, 1
  br i1 %.385119.not, label %B130.loopexit, label %B294.if.lr.ph

B294.if.lr.ph:
  %.460 = getelementptr i8, ptr %5, i64 64
  br label %B294.if

B294.if:
  %.329.0120 = phi i64 [ 0, %B294.if.lr.ph ], [ %.398, %B296.endif.endif ]
  %.398 = add nuw nsw i64 %.329.0120, 1
  store ptr null, ptr %.432, align 8
  %.436 = call i32 @run_group.1(ptr nonnull %.432, ptr nonnull %excinfo.1, ptr nonnull %arg.layout, i64 %4, i64 0, i64 %.329.0120, ptr %arg.kernels, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.local, ptr %arg.out)
  switch i32 %.436, label %B296.if [
    i32 -2, label %B296.endif
    i32 0, label %B296.endif
  ]

B296.if:
  %.444 = icmp sgt i32 %.436, 0
  %.437 = load ptr, ptr %excinfo.1, align 8
  %.445 = select i1 %.444, ptr %.437, ptr undef
  store ptr %.445, ptr %excinfo, align 8
  br label %common.ret

B296.endif:
  %.461 = load i64, ptr %.460, align 8
  %.463 = mul nsw i64 %.329.0120, %.297
  %6 = getelementptr i32, ptr %arg.rows, i64 %.461
  %.466 = getelementptr i32, ptr %6, i64 %.463
  store ptr null, ptr %.470, align 8
  %.474 = call i32 @scatter.2(ptr nonnull %.470, ptr nonnull %excinfo.2, i64 %.297, ptr %.466, ptr %arg.out, ptr %arg.r)
  switch i32 %.474, label %B296.endif.if [
    i32 -2, label %B296.endif.endif
    i32 0, label %B296.endif.endif
  ]

B296.endif.if:
  %.482 = icmp sgt i32 %.474, 0
  %.475 = load ptr, ptr %excinfo.2, align 8
  %.483 = select i1 %.482, ptr %.475, ptr undef
  store ptr %.483, ptr %excinfo, align 8
  br label %common.ret

B296.endif.endif:
  %exitcond.not = icmp eq i64 %.398, %.305
  br i1 %exitcond.not, label %B130.loopexit, label %B294.if
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
  %.143 = fadd double %.139, %.142
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
  %.436 = alloca ptr, align 8
  store ptr null, ptr %.436, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.474 = alloca ptr, align 8
  store ptr null, ptr %.474, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.32 = getelementptr i8, ptr %arg.layout, i64 16
  %.33 = load i64, ptr %.32, align 8
  %.34 = add nsw i64 %.33, 1
  %.36 = getelementptr i8, ptr %arg.layout, i64 24
  %.37 = load i64, ptr %.36, align 8
  %.38 = add nsw i64 %.34, %.37
  %.120116.not = icmp slt i64 %.38, 1
  br i1 %.120116.not, label %B106, label %B90.if.preheader

B90.if.preheader:
  %0 = shl nuw i64 %.38, 3
  call void @llvm.memset.p0.i64(ptr align 8 %arg.J, i8 0, i64 %0, i1 false)
  br label %B106

B106:
  %.167 = getelementptr i8, ptr %arg.layout, i64 32
  %.168 = load i64, ptr %.167, align 8
  %.248122.not = icmp slt i64 %.168, 1
  br i1 %.248122.not, label %B482, label %B158.if

B158.loopexit:
  %exitcond128.not = icmp eq i64 %.168, %.261
  br i1 %exitcond128.not, label %B482, label %B158.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B482 ], [ %.478, %B324.endif.if ], [ %.440, %B324.if ]
  ret i32 %common.ret.op

B482:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B158.if:
  %.192.0123 = phi i64 [ %.261, %B158.loopexit ], [ 0, %B106 ]
  %.261 = add nuw nsw i64 %.192.0123, 1
  %1 = mul nuw nsw i64 %.192.0123, 11
  %2 = add nuw nsw i64 %1, 8
  %3 = getelementptr i64, ptr %arg.layout, i64 %2
  %.294 = getelementptr i8, ptr %3, i64 40
  %.295 = load i64, ptr %.294, align 8
  %.299 = getelementptr i8, ptr %3, i64 8
  %.300 = load i64, ptr %.299, align 8
  %.301 = mul nsw i64 %.300, %.295
  %.309 = load i64, ptr %3, align 8
  %.389119.not = icmp slt i64 %.309, 1
  br i1 %.389119.not, label %B158.loopexit, label %B322.if.lr.ph

B322.if.lr.ph:
  %.464 = getelementptr i8, ptr %3, i64 72
  br label %B322.if

B322.if:
  %.333.0120 = phi i64 [ 0, %B322.if.lr.ph ], [ %.402, %B324.endif.endif ]
  %.402 = add nuw nsw i64 %.333.0120, 1
  store ptr null, ptr %.436, align 8
  %.440 = call i32 @run_group.5(ptr nonnull %.436, ptr nonnull %excinfo.1, ptr %arg.layout, i64 %2, i64 1, i64 %.333.0120, ptr %arg.kernels, ptr %arg.idx, ptr %arg.numbers, ptr %arg.Y, ptr %arg.local, ptr %arg.out)
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
  %.465 = load i64, ptr %.464, align 8
  %.467 = mul nsw i64 %.333.0120, %.301
  %4 = getelementptr i32, ptr %arg.pos, i64 %.465
  %.470 = getelementptr i32, ptr %4, i64 %.467
  store ptr null, ptr %.474, align 8
  %.478 = call i32 @scatter.2(ptr nonnull %.474, ptr nonnull %excinfo.2, i64 %.301, ptr %.470, ptr %arg.out, ptr %arg.J)
  switch i32 %.478, label %B324.endif.if [
    i32 -2, label %B324.endif.endif
    i32 0, label %B324.endif.endif
  ]

B324.endif.if:
  %.486 = icmp sgt i32 %.478, 0
  %.479 = load ptr, ptr %excinfo.2, align 8
  %.487 = select i1 %.486, ptr %.479, ptr undef
  store ptr %.487, ptr %excinfo, align 8
  br label %common.ret

B324.endif.endif:
  %exitcond.not = icmp eq i64 %.402, %.309
  br i1 %exitcond.not, label %B158.loopexit, label %B322.if
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

define i64 @lu_pattern(i64 %a0, ptr %a1, ptr %a2, i64 %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7) {
  %r = alloca i64, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @lu_pattern.8(ptr nonnull %r, ptr nonnull %e, i64 %a0, ptr %a1, ptr %a2, i64 %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7)
  %v = load i64, ptr %r, align 8
  ret i64 %v
}

define internal i32 @lu_pattern.8(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.start, ptr noalias %arg.columns, i64 %arg.capacity, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.follow) noinline {
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

define i64 @lu_fill(i64 %a0, i64 %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, double %a6, ptr %a7, ptr %a8, ptr %a9) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @lu_fill.9(ptr nonnull %r, ptr nonnull %e, i64 %a0, i64 %a1, i64 %a2, ptr %a3, ptr %a4, ptr %a5, double %a6, ptr %a7, ptr %a8, ptr %a9)
  ret i64 0
}

define internal i32 @lu_fill.9(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, i64 %arg.count, i64 %arg.entries, ptr noalias %arg.J, ptr noalias %arg.place, ptr noalias %arg.mass, double %arg.scale, ptr noalias %arg.order, ptr noalias %arg.diagonal, ptr noalias %arg.lu) noinline {
entry:
  %.113106.not = icmp slt i64 %arg.count, 1
  br i1 %.113106.not, label %B50, label %B34.if.preheader

B34.if.preheader:
  %0 = shl nuw i64 %arg.count, 3
  call void @llvm.memset.p0.i64(ptr align 8 %arg.lu, i8 0, i64 %0, i1 false)
  br label %B50

B50:
  %.241109.not = icmp slt i64 %arg.entries, 1
  br i1 %.241109.not, label %B142, label %B80.if

B142:
  %.385112.not = icmp slt i64 %arg.n, 1
  br i1 %.385112.not, label %B252, label %B172.if

B252:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B80.if:
  %.185.0110 = phi i64 [ %.254, %B80.if ], [ 0, %B50 ]
  %.254 = add nuw nsw i64 %.185.0110, 1
  %.280 = getelementptr i32, ptr %arg.place, i64 %.185.0110
  %.281 = load i32, ptr %.280, align 4
  %.283 = sext i32 %.281 to i64
  %.284 = getelementptr double, ptr %arg.lu, i64 %.283
  %.285 = load double, ptr %.284, align 8
  %.287 = getelementptr double, ptr %arg.J, i64 %.185.0110
  %.288 = load double, ptr %.287, align 8
  %.289 = fsub double %.285, %.288
  store double %.289, ptr %.284, align 8
  %exitcond.not = icmp eq i64 %arg.entries, %.254
  br i1 %exitcond.not, label %B142, label %B80.if

B172.if:
  %.329.0113 = phi i64 [ %.398, %B172.if ], [ 0, %B142 ]
  %.398 = add nuw nsw i64 %.329.0113, 1
  %.424 = getelementptr i32, ptr %arg.diagonal, i64 %.329.0113
  %.425 = load i32, ptr %.424, align 4
  %.427 = sext i32 %.425 to i64
  %.428 = getelementptr double, ptr %arg.lu, i64 %.427
  %.429 = load double, ptr %.428, align 8
  %.431 = getelementptr i32, ptr %arg.order, i64 %.329.0113
  %.432 = load i32, ptr %.431, align 4
  %.434 = sext i32 %.432 to i64
  %.435 = getelementptr double, ptr %arg.mass, i64 %.434
  %.436 = load double, ptr %.435, align 8
  %.438 = fmul double %arg.scale, %.436
  %.439 = fadd double %.429, %.438
  store double %.439, ptr %.428, align 8
  %exitcond115.not = icmp eq i64 %arg.n, %.398
  br i1 %exitcond115.not, label %B252, label %B172.if
}

define i64 @lu_factor(i64 %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5) {
  %r = alloca i64, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @lu_factor.10(ptr nonnull %r, ptr nonnull %e, i64 %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5)
  %v = load i64, ptr %r, align 8
  ret i64 %v
}

define internal i32 @lu_factor.10(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.lu, ptr noalias %arg.row) noinline {
entry:
  %.102211.not = icmp slt i64 %arg.n, 1
  br i1 %.102211.not, label %common.ret, label %B36.if

B166:
  %.341 = sub i32 %.150, %.146
  %.384205.not = icmp slt i32 %.341, 1
  br i1 %.384205.not, label %B412, label %B198.if

B198.loopexit:
  %.384 = icmp sgt i32 %.331.0207, 1
  br i1 %.384, label %B198.if, label %B412

B412:
  %.645 = sub i32 %.155, %.150
  %.688208.not = icmp slt i32 %.645, 1
  br i1 %.688208.not, label %B484, label %B444.if

B484:
  %.745 = sext i32 %.150 to i64
  %.746 = getelementptr double, ptr %arg.lu, i64 %.745
  %.747 = load double, ptr %.746, align 8
  %.752 = fcmp une double %.747, 0.000000e+00
  %.755 = fsub double %.747, %.747
  %.756 = fcmp ord double %.755, 0.000000e+00
  %or.cond = and i1 %.752, %.756
  br i1 %or.cond, label %B566, label %common.ret

common.ret:
  %storemerge194 = phi i64 [ 0, %entry ], [ %.115, %B484 ], [ 0, %B566 ]
  store i64 %storemerge194, ptr %retptr, align 8
  ret i32 0

B566:
  %.786 = fdiv double 1.000000e+00, %.747
  store double %.786, ptr %.746, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.115
  br i1 %exitcond.not, label %common.ret, label %B36.if

B36.if:
  %.43.0212 = phi i64 [ %.115, %B566 ], [ 0, %entry ]
  %.115 = add nuw nsw i64 %.43.0212, 1
  %.145 = getelementptr i32, ptr %arg.lu_start, i64 %.43.0212
  %.146 = load i32, ptr %.145, align 4
  %.149 = getelementptr i32, ptr %arg.diagonal, i64 %.43.0212
  %.150 = load i32, ptr %.149, align 4
  %.154 = getelementptr i32, ptr %arg.lu_start, i64 %.115
  %.155 = load i32, ptr %.154, align 4
  %.203 = sub i32 %.155, %.146
  %.246199.not = icmp slt i32 %.203, 1
  br i1 %.246199.not, label %B166, label %B126.if

B126.if:
  %.193.0201 = phi i32 [ %.255, %B126.if ], [ %.203, %B36.if ]
  %.190.0200 = phi i32 [ %.259, %B126.if ], [ %.146, %B36.if ]
  %.255 = add nsw i32 %.193.0201, -1
  %.259 = add i32 %.190.0200, 1
  %0 = sext i32 %.190.0200 to i64
  %.286 = getelementptr double, ptr %arg.lu, i64 %0
  %.287 = load double, ptr %.286, align 8
  %.290 = getelementptr i32, ptr %arg.lu_columns, i64 %0
  %.291 = load i32, ptr %.290, align 4
  %.293 = sext i32 %.291 to i64
  %.294 = getelementptr double, ptr %arg.row, i64 %.293
  store double %.287, ptr %.294, align 8
  %.246 = icmp sgt i32 %.193.0201, 1
  br i1 %.246, label %B126.if, label %B166

B198.if:
  %.331.0207 = phi i32 [ %.393, %B198.loopexit ], [ %.341, %B166 ]
  %.328.0206 = phi i32 [ %.397, %B198.loopexit ], [ %.146, %B166 ]
  %.393 = add nsw i32 %.331.0207, -1
  %.397 = add i32 %.328.0206, 1
  %1 = sext i32 %.328.0206 to i64
  %.424 = getelementptr i32, ptr %arg.lu_columns, i64 %1
  %.425 = load i32, ptr %.424, align 4
  %.427 = sext i32 %.425 to i64
  %.428 = getelementptr double, ptr %arg.row, i64 %.427
  %.429 = load double, ptr %.428, align 8
  %.432 = getelementptr i32, ptr %arg.diagonal, i64 %.427
  %.433 = load i32, ptr %.432, align 4
  %.435 = sext i32 %.433 to i64
  %.436 = getelementptr double, ptr %arg.lu, i64 %.435
  %.437 = load double, ptr %.436, align 8
  %.438 = fmul double %.429, %.437
  %.445 = getelementptr double, ptr %arg.lu, i64 %1
  store double %.438, ptr %.445, align 8
  %.452 = add nsw i64 %.435, 1
  %2 = getelementptr i32, ptr %arg.lu_start, i64 %.427
  %.456 = getelementptr i8, ptr %2, i64 4
  %.457 = load i32, ptr %.456, align 4
  %.458 = sext i32 %.457 to i64
  %.495 = sub nsw i64 %.458, %.452
  %.538202.not = icmp slt i64 %.495, 1
  br i1 %.538202.not, label %B198.loopexit, label %B342.if

B342.if:
  %.485.0204 = phi i64 [ %.547, %B342.if ], [ %.495, %B198.if ]
  %.482.0203 = phi i64 [ %.551, %B342.if ], [ %.452, %B198.if ]
  %.547 = add nsw i64 %.485.0204, -1
  %.551 = add nsw i64 %.482.0203, 1
  %.577 = getelementptr i32, ptr %arg.lu_columns, i64 %.482.0203
  %.578 = load i32, ptr %.577, align 4
  %.580 = sext i32 %.578 to i64
  %.581 = getelementptr double, ptr %arg.row, i64 %.580
  %.582 = load double, ptr %.581, align 8
  %.584 = getelementptr double, ptr %arg.lu, i64 %.482.0203
  %.585 = load double, ptr %.584, align 8
  %.587 = fmul double %.438, %.585
  %.588 = fsub double %.582, %.587
  store double %.588, ptr %.581, align 8
  %.538 = icmp sgt i64 %.485.0204, 1
  br i1 %.538, label %B342.if, label %B198.loopexit

B444.if:
  %.635.0210 = phi i32 [ %.697, %B444.if ], [ %.645, %B412 ]
  %.632.0209 = phi i32 [ %.701, %B444.if ], [ %.150, %B412 ]
  %.697 = add nsw i32 %.635.0210, -1
  %.701 = add i32 %.632.0209, 1
  %3 = sext i32 %.632.0209 to i64
  %.728 = getelementptr i32, ptr %arg.lu_columns, i64 %3
  %.729 = load i32, ptr %.728, align 4
  %.731 = sext i32 %.729 to i64
  %.732 = getelementptr double, ptr %arg.row, i64 %.731
  %.733 = load double, ptr %.732, align 8
  %.736 = getelementptr double, ptr %arg.lu, i64 %3
  store double %.733, ptr %.736, align 8
  %.688 = icmp sgt i32 %.635.0210, 1
  br i1 %.688, label %B444.if, label %B484
}

define i64 @lu_solve(i64 %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8) {
  %r = alloca ptr, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @lu_solve.11(ptr nonnull %r, ptr nonnull %e, i64 %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, ptr %a8)
  ret i64 0
}

define internal i32 @lu_solve.11(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.order, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.lu, ptr noalias %arg.right, ptr noalias %arg.solution, ptr noalias %arg.x) noinline {
entry:
  %.113192.not = icmp slt i64 %arg.n, 1
  br i1 %.113192.not, label %B192, label %B34.if

B180:
  %rest.4.1.lcssa = phi double [ %.161, %B34.if ], [ %.304, %B122.if ]
  %.315 = getelementptr double, ptr %arg.x, i64 %.55.0193
  store double %rest.4.1.lcssa, ptr %.315, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.126
  br i1 %exitcond.not, label %B192, label %B34.if

B192:
  %.409201.not = icmp slt i64 %arg.n, 1
  br i1 %.409201.not, label %B450.preheader, label %B232.if

B450.preheader:
  %.719204.not = icmp slt i64 %arg.n, 1
  br i1 %.719204.not, label %B490, label %B450.if

B378:
  %rest.5.1.lcssa = phi double [ %.453, %B232.if ], [ %.598, %B320.if ]
  %.612 = getelementptr double, ptr %arg.lu, i64 %.461
  %.613 = load double, ptr %.612, align 8
  %.615 = fmul double %rest.5.1.lcssa, %.613
  store double %.615, ptr %.452, align 8
  %.409 = icmp sgt i64 %.356.0202, 1
  br i1 %.409, label %B232.if, label %B450.preheader

B490:
  store ptr null, ptr %retptr, align 8
  ret i32 0

B34.if:
  %.55.0193 = phi i64 [ %.126, %B180 ], [ 0, %entry ]
  %.126 = add nuw nsw i64 %.55.0193, 1
  %.156 = getelementptr i32, ptr %arg.order, i64 %.55.0193
  %.157 = load i32, ptr %.156, align 4
  %.159 = sext i32 %.157 to i64
  %.160 = getelementptr double, ptr %arg.right, i64 %.159
  %.161 = load double, ptr %.160, align 8
  %.167 = getelementptr i32, ptr %arg.lu_start, i64 %.55.0193
  %.168 = load i32, ptr %.167, align 4
  %.171 = getelementptr i32, ptr %arg.diagonal, i64 %.55.0193
  %.172 = load i32, ptr %.171, align 4
  %.209 = sub i32 %.172, %.168
  %.252188.not = icmp slt i32 %.209, 1
  br i1 %.252188.not, label %B180, label %B122.if

B122.if:
  %rest.4.1191 = phi double [ %.304, %B122.if ], [ %.161, %B34.if ]
  %.199.0190 = phi i32 [ %.261, %B122.if ], [ %.209, %B34.if ]
  %.196.0189 = phi i32 [ %.265, %B122.if ], [ %.168, %B34.if ]
  %.261 = add nsw i32 %.199.0190, -1
  %.265 = add i32 %.196.0189, 1
  %0 = sext i32 %.196.0189 to i64
  %.292 = getelementptr double, ptr %arg.lu, i64 %0
  %.293 = load double, ptr %.292, align 8
  %.296 = getelementptr i32, ptr %arg.lu_columns, i64 %0
  %.297 = load i32, ptr %.296, align 4
  %.299 = sext i32 %.297 to i64
  %.300 = getelementptr double, ptr %arg.x, i64 %.299
  %.301 = load double, ptr %.300, align 8
  %.302 = fmul double %.293, %.301
  %.304 = fsub double %rest.4.1191, %.302
  %.252 = icmp sgt i32 %.199.0190, 1
  br i1 %.252, label %B122.if, label %B180

B232.if:
  %.353.0203.in = phi i64 [ %.353.0203, %B378 ], [ %arg.n, %B192 ]
  %.356.0202 = phi i64 [ %.418, %B378 ], [ %arg.n, %B192 ]
  %.353.0203 = add i64 %.353.0203.in, -1
  %.418 = add nsw i64 %.356.0202, -1
  %.452 = getelementptr double, ptr %arg.x, i64 %.353.0203
  %.453 = load double, ptr %.452, align 8
  %.459 = getelementptr i32, ptr %arg.diagonal, i64 %.353.0203
  %.460 = load i32, ptr %.459, align 4
  %.461 = sext i32 %.460 to i64
  %.462 = add nsw i64 %.461, 1
  %1 = getelementptr i32, ptr %arg.lu_start, i64 %.353.0203
  %.466 = getelementptr i8, ptr %1, i64 4
  %.467 = load i32, ptr %.466, align 4
  %.468 = sext i32 %.467 to i64
  %.505 = sub nsw i64 %.468, %.462
  %.548195.not = icmp slt i64 %.505, 1
  br i1 %.548195.not, label %B378, label %B320.if

B320.if:
  %rest.5.1198 = phi double [ %.598, %B320.if ], [ %.453, %B232.if ]
  %.495.0197 = phi i64 [ %.557, %B320.if ], [ %.505, %B232.if ]
  %.492.0196 = phi i64 [ %.561, %B320.if ], [ %.462, %B232.if ]
  %.557 = add nsw i64 %.495.0197, -1
  %.561 = add nsw i64 %.492.0196, 1
  %.587 = getelementptr double, ptr %arg.lu, i64 %.492.0196
  %.588 = load double, ptr %.587, align 8
  %.590 = getelementptr i32, ptr %arg.lu_columns, i64 %.492.0196
  %.591 = load i32, ptr %.590, align 4
  %.593 = sext i32 %.591 to i64
  %.594 = getelementptr double, ptr %arg.x, i64 %.593
  %.595 = load double, ptr %.594, align 8
  %.596 = fmul double %.588, %.595
  %.598 = fsub double %rest.5.1198, %.596
  %.548 = icmp sgt i64 %.495.0197, 1
  br i1 %.548, label %B320.if, label %B378

B450.if:
  %.663.0205 = phi i64 [ %.732, %B450.if ], [ 0, %B450.preheader ]
  %.732 = add nuw nsw i64 %.663.0205, 1
  %.758 = getelementptr double, ptr %arg.x, i64 %.663.0205
  %.759 = load double, ptr %.758, align 8
  %.761 = getelementptr i32, ptr %arg.order, i64 %.663.0205
  %.762 = load i32, ptr %.761, align 4
  %.764 = sext i32 %.762 to i64
  %.765 = getelementptr double, ptr %arg.solution, i64 %.764
  store double %.759, ptr %.765, align 8
  %exitcond207.not = icmp eq i64 %arg.n, %.732
  br i1 %exitcond207.not, label %B490, label %B450.if
}

define i64 @march(ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, i64 %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, ptr %a14, i64 %a15, ptr %a16, ptr %a17, ptr %a18, ptr %a19, i64 %a20, i64 %a21, ptr %a22, ptr %a23, ptr %a24, ptr %a25, ptr %a26, ptr %a27) {
  %r = alloca i64, align 8
  %e = alloca ptr, align 8
  %1 = call i32 @march.12(ptr nonnull %r, ptr nonnull %e, ptr %a0, ptr %a1, ptr %a2, ptr %a3, ptr %a4, ptr %a5, ptr %a6, ptr %a7, i64 %a8, ptr %a9, ptr %a10, ptr %a11, ptr %a12, ptr %a13, ptr %a14, i64 %a15, ptr %a16, ptr %a17, ptr %a18, ptr %a19, i64 %a20, i64 %a21, ptr %a22, ptr %a23, ptr %a24, ptr %a25, ptr %a26, ptr %a27)
  %v = load i64, ptr %r, align 8
  ret i64 %v
}

define internal i32 @march.12(ptr noalias %retptr, ptr noalias %excinfo, ptr noalias %arg.layout, ptr noalias %arg.kernels, ptr noalias %arg.idx, ptr noalias %arg.rows, ptr noalias %arg.pos, ptr noalias %arg.numbers, ptr noalias %arg.drive_rows, ptr noalias %arg.drive_columns, i64 %arg.factors, ptr noalias %arg.place, ptr noalias %arg.order, ptr noalias %arg.lu_start, ptr noalias %arg.lu_columns, ptr noalias %arg.diagonal, ptr noalias %arg.mass, i64 %arg.tested, ptr noalias %arg.powers, ptr noalias %arg.method, ptr noalias %arg.settings, ptr noalias %arg.edges, i64 %arg.edge_count, i64 %arg.max_steps, ptr noalias %arg.y, ptr noalias %arg.Y, ptr noalias %arg.state, ptr noalias %arg.counts, ptr noalias %arg.outputs, ptr noalias %arg.work) noinline {
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
  %.1496 = alloca ptr, align 8
  store ptr null, ptr %.1496, align 8
  %excinfo.16 = alloca ptr, align 8
  store ptr null, ptr %excinfo.16, align 8
  %.1541 = alloca ptr, align 8
  store ptr null, ptr %.1541, align 8
  %excinfo.17 = alloca ptr, align 8
  store ptr null, ptr %excinfo.17, align 8
  %.1568 = alloca ptr, align 8
  store ptr null, ptr %.1568, align 8
  %excinfo.18 = alloca ptr, align 8
  store ptr null, ptr %excinfo.18, align 8
  %.1602 = alloca double, align 8
  store double 0.000000e+00, ptr %.1602, align 8
  %excinfo.19 = alloca ptr, align 8
  store ptr null, ptr %excinfo.19, align 8
  %.1637 = alloca double, align 8
  store double 0.000000e+00, ptr %.1637, align 8
  %excinfo.20 = alloca ptr, align 8
  store ptr null, ptr %excinfo.20, align 8
  %.1686 = alloca double, align 8
  store double 0.000000e+00, ptr %.1686, align 8
  %excinfo.21 = alloca ptr, align 8
  store ptr null, ptr %excinfo.21, align 8
  %.1949 = alloca ptr, align 8
  store ptr null, ptr %.1949, align 8
  %excinfo.22 = alloca ptr, align 8
  store ptr null, ptr %excinfo.22, align 8
  %.1995 = alloca double, align 8
  store double 0.000000e+00, ptr %.1995, align 8
  %excinfo.23 = alloca ptr, align 8
  store ptr null, ptr %excinfo.23, align 8
  %.2026 = alloca ptr, align 8
  store ptr null, ptr %.2026, align 8
  %excinfo.24 = alloca ptr, align 8
  store ptr null, ptr %excinfo.24, align 8
  %.2150 = alloca double, align 8
  store double 0.000000e+00, ptr %.2150, align 8
  %excinfo.25 = alloca ptr, align 8
  store ptr null, ptr %excinfo.25, align 8
  %.2192 = alloca double, align 8
  store double 0.000000e+00, ptr %.2192, align 8
  %excinfo.26 = alloca ptr, align 8
  store ptr null, ptr %excinfo.26, align 8
  %.2242 = alloca double, align 8
  store double 0.000000e+00, ptr %.2242, align 8
  %excinfo.27 = alloca ptr, align 8
  store ptr null, ptr %excinfo.27, align 8
  %.2274 = alloca double, align 8
  store double 0.000000e+00, ptr %.2274, align 8
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
  %.idx309 = mul i64 %.86, 104
  %3 = getelementptr i8, ptr %arg.work, i64 %.idx309
  %.138 = getelementptr i8, ptr %3, i64 8
  %.idx310 = mul i64 %.86, 112
  %4 = getelementptr i8, ptr %arg.work, i64 %.idx310
  %.151 = getelementptr i8, ptr %4, i64 8
  %.157 = getelementptr double, ptr %.151, i64 %arg.factors
  %.164 = getelementptr i8, ptr %arg.layout, i64 24
  %.165 = load i64, ptr %.164, align 8
  %5 = getelementptr double, ptr %.157, i64 %.89
  %6 = getelementptr i8, ptr %5, i64 8
  %.168 = getelementptr double, ptr %6, i64 %.165
  %7 = getelementptr double, ptr %.168, i64 %.98
  %.177 = getelementptr i8, ptr %7, i64 8
  %.182 = getelementptr i8, ptr %arg.layout, i64 48
  %.183 = load i64, ptr %.182, align 8
  %.185 = getelementptr double, ptr %.177, i64 %.183
  %8 = getelementptr double, ptr %arg.edges, i64 %arg.edge_count
  %.192 = getelementptr i8, ptr %8, i64 -8
  %.193 = load double, ptr %.192, align 8
  %.199 = load i64, ptr %arg.counts, align 8
  %.288490.not = icmp slt i64 %arg.max_steps, 1
  br i1 %.288490.not, label %B3550, label %B712.if.lr.ph

B712.if.lr.ph:
  %.100 = add nsw i64 %.98, %.86
  %.330 = getelementptr i8, ptr %arg.state, i64 8
  %.463 = getelementptr double, ptr %arg.Y, i64 %.100
  %storemerge311 = call i64 @llvm.smax.i64(i64 %.86, i64 0)
  %.646479.not = icmp slt i64 %.86, 1
  %.844 = getelementptr i8, ptr %arg.counts, i64 32
  %.854 = getelementptr i8, ptr %arg.method, i64 1344
  %.928 = getelementptr i8, ptr %arg.counts, i64 8
  %.1327 = getelementptr double, ptr %arg.Y, i64 %.100
  %.1526 = getelementptr i8, ptr %arg.counts, i64 24
  %.1536.idx = mul i64 %.86, 56
  %.1536 = getelementptr i8, ptr %arg.work, i64 %.1536.idx
  %.1593 = getelementptr i8, ptr %arg.settings, i64 8
  %.1988 = getelementptr i8, ptr %arg.state, i64 16
  %.1991 = getelementptr i8, ptr %arg.method, i64 1352
  %.2238 = getelementptr i8, ptr %arg.settings, i64 16
  %.1674 = getelementptr i8, ptr %arg.counts, i64 16
  %.1682 = getelementptr i8, ptr %arg.method, i64 1352
  %.1723 = getelementptr i8, ptr %arg.settings, i64 24
  %arg.state.promoted = load double, ptr %arg.state, align 8
  %.330.promoted = load double, ptr %.330, align 8
  %9 = shl nuw i64 %storemerge311, 3
  %10 = add i64 %arg.edge_count, -1
  br label %B712.if

B810:
  %.376 = fmul double %.340, 5.000000e-01
  %.378 = fcmp ogt double %.331495, %.376
  br i1 %.378, label %B828, label %B866

B828:
  store double 0.000000e+00, ptr %.391, align 8
  %.397 = call i32 @numba.13(ptr nonnull %.391, ptr nonnull %excinfo.1, double %.331495, double %.376)
  switch i32 %.397, label %B828.endif.if [
    i32 -2, label %B828.endif.endif
    i32 0, label %B828.endif.endif
  ]

B866:
  %h.3.1 = phi double [ %.331495, %B810 ], [ %.407, %B828.endif.endif ], [ %.340, %B712.if ]
  br i1 %fresh.3.0492, label %B1298, label %B870

B870:
  store ptr null, ptr %.436, align 8
  %.440 = call i32 @copy.14(ptr nonnull %.436, ptr nonnull %excinfo.2, i64 %.86, ptr %arg.y, ptr %arg.Y)
  switch i32 %.440, label %B870.if [
    i32 -2, label %B870.endif
    i32 0, label %B870.endif
  ]

B1096:
  %.694 = load i64, ptr %.164, align 8
  %.774482.not = icmp slt i64 %.694, 1
  br i1 %.774482.not, label %B1252, label %B1148.if

B1252:
  %.845 = load i64, ptr %.844, align 8
  %.846 = add nsw i64 %.845, 1
  store i64 %.846, ptr %.844, align 8
  br label %B1298

B1298:
  %.855 = load double, ptr %.854, align 8
  %.857 = fmul double %h.3.1, %.855
  %.861 = fdiv double 1.000000e+00, %.857
  store ptr null, ptr %.872, align 8
  %.876 = call i32 @lu_fill.9(ptr nonnull %.872, ptr nonnull %excinfo.6, i64 %.86, i64 %arg.factors, i64 %.89, ptr %.157, ptr %arg.place, ptr %arg.mass, double %.861, ptr %arg.order, ptr %arg.diagonal, ptr %.151)
  switch i32 %.876, label %B1298.endif.if [
    i32 -2, label %B1298.endif.endif
    i32 0, label %B1298.endif.endif
  ]

B1572:
  store ptr null, ptr %.1069, align 8
  %.1073 = call i32 @copy.14(ptr nonnull %.1069, ptr nonnull %excinfo.8, i64 %.86, ptr %arg.y, ptr %.110)
  switch i32 %.1073, label %B1572.if [
    i32 -2, label %B1572.endif
    i32 0, label %B1572.endif
  ]

B1738:
  %.1256 = add nsw i64 %.964.0488, -1
  %.1258 = mul nsw i64 %.1256, %.86
  %.1260 = getelementptr double, ptr %arg.work, i64 %.1258
  store ptr null, ptr %.1263, align 8
  %.1267 = call i32 @add_scaled.15(ptr nonnull %.1263, ptr nonnull %excinfo.10, i64 %.86, double 1.000000e+00, ptr %.1260, ptr %.110)
  switch i32 %.1267, label %B1738.if [
    i32 -2, label %B1814
    i32 0, label %B1814
  ]

B1814:
  store ptr null, ptr %.1292, align 8
  %.1296 = call i32 @copy.14(ptr nonnull %.1292, ptr nonnull %excinfo.11, i64 %.86, ptr %.110, ptr %arg.Y)
  switch i32 %.1296, label %B1814.if [
    i32 -2, label %B1814.endif
    i32 0, label %B1814.endif
  ]

B2132:
  store ptr null, ptr %.1451, align 8
  %.1455 = call i32 @add_scaled.15(ptr nonnull %.1451, ptr nonnull %excinfo.15, i64 %.86, double %.1439, ptr %.130, ptr %.113)
  switch i32 %.1455, label %B2132.if [
    i32 -2, label %B2168
    i32 0, label %B2168
  ]

B2168:
  %.1482 = mul nsw i64 %.964.0488, %.86
  %.1486 = getelementptr double, ptr %arg.work, i64 %.1482
  store ptr null, ptr %.1496, align 8
  %.1500 = call i32 @lu_solve.11(ptr nonnull %.1496, ptr nonnull %excinfo.16, i64 %.86, ptr %arg.order, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %.151, ptr %.113, ptr %.1486, ptr %.138)
  switch i32 %.1500, label %B2168.if [
    i32 -2, label %B2168.endif
    i32 0, label %B2168.endif
  ]

B2256:
  %.1527 = load i64, ptr %.1526, align 8
  %.1528 = add nsw i64 %.1527, 8
  store i64 %.1528, ptr %.1526, align 8
  store ptr null, ptr %.1541, align 8
  %.1545 = call i32 @copy.14(ptr nonnull %.1541, ptr nonnull %excinfo.17, i64 %.86, ptr %.110, ptr %.117)
  switch i32 %.1545, label %B2256.if [
    i32 -2, label %B2256.endif
    i32 0, label %B2256.endif
  ]

B2558:
  %error.2.1 = phi double [ %.1651, %B2256.endif.endif.endif.endif.endif ], [ 0x7FF0000000000000, %B1298.endif.endif.endif ]
  %.1665 = fcmp ugt double %error.2.1, 1.000000e+00
  br i1 %.1665, label %B2570, label %B2770

B2570:
  %.1675 = load i64, ptr %.1674, align 8
  %.1676 = add nsw i64 %.1675, 1
  store i64 %.1676, ptr %.1674, align 8
  %.1683 = load double, ptr %.1682, align 8
  store double 0.000000e+00, ptr %.1686, align 8
  %.1690 = call i32 @step_factor.16(ptr nonnull %.1686, ptr nonnull %excinfo.21, double %error.2.1, double 1.000000e+00, double %.1683, ptr %arg.settings)
  switch i32 %.1690, label %B2570.if [
    i32 -2, label %B2570.endif
    i32 0, label %B2570.endif
  ]

common.ret:
  %common.ret.op = phi i32 [ 0, %B2748 ], [ 0, %B3550 ], [ %.2280, %B3418.endif.if ], [ %.2248, %B3418.if ], [ %.397, %B828.endif.if ], [ %.440, %B870.if ], [ %.478, %B870.endif.if ], [ %.512, %B870.endif.endif.if ], [ %.2198, %B3290.endif.endif.if ], [ %.2156, %B3290.if ], [ %.546, %B870.endif.endif.endif.if ], [ %.876, %B1298.endif.if ], [ 0, %B3290.endif.endif.endif ], [ %.907, %B1298.endif.endif.if ], [ %.2030, %B3152.endif.if ], [ %.1073, %B1572.if ], [ %.1228, %B1638.if ], [ %.1267, %B1738.if ], [ %.1296, %B1814.if ], [ %.1342, %B1814.endif.if ], [ %.1376, %B1814.endif.endif.if ], [ %.1413, %B1814.endif.endif.endif.if ], [ %.1455, %B2132.if ], [ %.1500, %B2168.if ], [ %.1545, %B2256.if ], [ %.1572, %B2256.endif.if ], [ %.1608, %B2256.endif.endif.endif.if ], [ %.1641, %B2256.endif.endif.endif.endif.if ], [ %.1690, %B2570.if ], [ %.1953, %B2942.if ], [ %.1999, %B3152.if ]
  ret i32 %common.ret.op

B2748:
  store i64 2, ptr %retptr, align 8
  br label %common.ret

B2770:
  %.1830 = fadd double %until.2.1494, %h.3.1
  %until.2.1 = select i1 %.347, double %.193, double %.1830
  %.1842 = load i64, ptr %arg.counts, align 8
  %.1852 = icmp slt i64 %.1842, %arg.edge_count
  br i1 %.1852, label %B2826, label %B2908

B2826:
  %.1863 = getelementptr double, ptr %arg.edges, i64 %.1842
  %.1864 = load double, ptr %.1863, align 8
  %.1868 = fmul double %until.2.1, 0x3FF0000000000005
  %.1869 = fcmp ugt double %.1864, %.1868
  br i1 %.1869, label %B2908, label %B2856

B2856:
  %stop.2.1 = phi i64 [ %.1875, %B2878 ], [ %.1842, %B2826 ]
  %exitcond645.not = icmp eq i64 %stop.2.1, %10
  br i1 %exitcond645.not, label %B2908, label %B2878

B2878:
  %.1875 = add nsw i64 %stop.2.1, 1
  %.1896 = getelementptr double, ptr %arg.edges, i64 %.1875
  %.1897 = load double, ptr %.1896, align 8
  %.1902 = fcmp ugt double %.1897, %.1868
  br i1 %.1902, label %B2908, label %B2856

B2908:
  %stop.3.2 = phi i64 [ %.1842, %B2826 ], [ %.1842, %B2770 ], [ %arg.edge_count, %B2856 ], [ %.1875, %B2878 ]
  %.1919 = icmp sgt i64 %stop.3.2, %.1842
  br i1 %.1919, label %B2942, label %B3152

B2942:
  %.1926 = getelementptr double, ptr %arg.edges, i64 %.1842
  %.1931 = sub nsw i64 %stop.3.2, %.1842
  %.1936 = sub nsw i64 %.1842, %.199
  %.1938 = mul nsw i64 %.1936, %.86
  %.1940 = getelementptr double, ptr %arg.outputs, i64 %.1938
  store ptr null, ptr %.1949, align 8
  %.1953 = call i32 @dense_output.17(ptr nonnull %.1949, ptr nonnull %excinfo.22, i64 %.86, ptr %arg.y, ptr %.117, ptr %arg.work, ptr %arg.method, double %until.2.1494, double %until.2.1, ptr %.1926, i64 %.1931, ptr %.1940, ptr %.113)
  switch i32 %.1953, label %B2942.if [
    i32 -2, label %B2942.endif
    i32 0, label %B2942.endif
  ]

B3152:
  %.1989 = load double, ptr %.1988, align 8
  %.1992 = load double, ptr %.1991, align 8
  store double 0.000000e+00, ptr %.1995, align 8
  %.1999 = call i32 @step_factor.16(ptr nonnull %.1995, ptr nonnull %excinfo.23, double %error.2.1, double %.1989, double %.1992, ptr %arg.settings)
  %.2009 = load double, ptr %.1995, align 8
  switch i32 %.1999, label %B3152.if [
    i32 -2, label %B3152.endif
    i32 0, label %B3152.endif
  ]

B3290:
  store double 0.000000e+00, ptr %.2150, align 8
  %.2156 = call i32 @numba.18(ptr nonnull %.2150, ptr nonnull %excinfo.25, double %.331495, double %h.3.1)
  %.2166 = load double, ptr %.2150, align 8
  switch i32 %.2156, label %B3290.if [
    i32 -2, label %B3290.endif
    i32 0, label %B3290.endif
  ]

B3418:
  %.2232 = fmul double %h.3.1, %.2009
  %.2239 = load double, ptr %.2238, align 8
  store double 0.000000e+00, ptr %.2242, align 8
  %.2248 = call i32 @numba.13(ptr nonnull %.2242, ptr nonnull %excinfo.27, double %.2232, double %.2239)
  switch i32 %.2248, label %B3418.if [
    i32 -2, label %B3418.endif
    i32 0, label %B3418.endif
  ]

B3550:
  store i64 1, ptr %retptr, align 8
  br label %common.ret

B3551:
  %.331496 = phi double [ %.1713, %B2570.endif ], [ %.2258, %B3418.endif.endif ]
  %until.2.1493 = phi double [ %until.2.1494, %B2570.endif ], [ %until.2.1, %B3418.endif.endif ]
  %.288 = icmp sgt i64 %.232.0491, 1
  br i1 %.288, label %B712.if, label %B3550

B712.if:
  %.331495 = phi double [ %.330.promoted, %B712.if.lr.ph ], [ %.331496, %B3551 ]
  %until.2.1494 = phi double [ %arg.state.promoted, %B712.if.lr.ph ], [ %until.2.1493, %B3551 ]
  %fresh.3.0492 = phi i1 [ false, %B712.if.lr.ph ], [ %.1665, %B3551 ]
  %.232.0491 = phi i64 [ %arg.max_steps, %B712.if.lr.ph ], [ %.297, %B3551 ]
  %.297 = add nsw i64 %.232.0491, -1
  %.340 = fsub double %.193, %until.2.1494
  %.345 = fmul double %.340, 0x3FEFFFFFFF768FA1
  %.347 = fcmp oge double %.331495, %.345
  br i1 %.347, label %B866, label %B810

B828.endif.if:
  %.405 = icmp sgt i32 %.397, 0
  %.398 = load ptr, ptr %excinfo.1, align 8
  %.406 = select i1 %.405, ptr %.398, ptr undef
  store ptr %.406, ptr %excinfo, align 8
  br label %common.ret

B828.endif.endif:
  %.407 = load double, ptr %.391, align 8
  br label %B866

B870.if:
  %.448 = icmp sgt i32 %.440, 0
  %.441 = load ptr, ptr %excinfo.2, align 8
  %.449 = select i1 %.448, ptr %.441, ptr undef
  store ptr %.449, ptr %excinfo, align 8
  br label %common.ret

B870.endif:
  store double %until.2.1494, ptr %.463, align 8
  store ptr null, ptr %.474, align 8
  %.478 = call i32 @drive.6(ptr nonnull %.474, ptr nonnull %excinfo.3, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.177, ptr %.185)
  switch i32 %.478, label %B870.endif.if [
    i32 -2, label %B870.endif.endif
    i32 0, label %B870.endif.endif
  ]

B870.endif.if:
  %.486 = icmp sgt i32 %.478, 0
  %.479 = load ptr, ptr %excinfo.3, align 8
  %.487 = select i1 %.486, ptr %.479, ptr undef
  store ptr %.487, ptr %excinfo, align 8
  br label %common.ret

B870.endif.endif:
  store ptr null, ptr %.508, align 8
  %.512 = call i32 @jacobian.4(ptr nonnull %.508, ptr nonnull %excinfo.4, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.pos, ptr %arg.numbers, ptr %arg.Y, ptr %.157, ptr %.177, ptr %.185)
  switch i32 %.512, label %B870.endif.endif.if [
    i32 -2, label %B870.endif.endif.endif
    i32 0, label %B870.endif.endif.endif
  ]

B870.endif.endif.if:
  %.520 = icmp sgt i32 %.512, 0
  %.513 = load ptr, ptr %excinfo.4, align 8
  %.521 = select i1 %.520, ptr %.513, ptr undef
  store ptr %.521, ptr %excinfo, align 8
  br label %common.ret

B870.endif.endif.endif:
  store ptr null, ptr %.542, align 8
  %.546 = call i32 @drive_rates.7(ptr nonnull %.542, ptr nonnull %excinfo.5, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.168, ptr %.177, ptr %.185)
  switch i32 %.546, label %B870.endif.endif.endif.if [
    i32 -2, label %B870.endif.endif.endif.endif
    i32 0, label %B870.endif.endif.endif.endif
  ]

B870.endif.endif.endif.if:
  %.554 = icmp sgt i32 %.546, 0
  %.547 = load ptr, ptr %excinfo.5, align 8
  %.555 = select i1 %.554, ptr %.547, ptr undef
  store ptr %.555, ptr %excinfo, align 8
  br label %common.ret

B870.endif.endif.endif.endif:
  br i1 %.646479.not, label %B1096, label %B1080.if.preheader

B1080.if.preheader:
  call void @llvm.memset.p0.i64(ptr align 8 %.130, i8 0, i64 %9, i1 false)
  br label %B1096

B1148.if:
  %.718.0483 = phi i64 [ %.787, %B1148.if ], [ 0, %B1096 ]
  %.787 = add nuw nsw i64 %.718.0483, 1
  %.813 = getelementptr i32, ptr %arg.drive_rows, i64 %.718.0483
  %.814 = load i32, ptr %.813, align 4
  %.816 = sext i32 %.814 to i64
  %.817 = getelementptr double, ptr %.130, i64 %.816
  %.818 = load double, ptr %.817, align 8
  %.823 = getelementptr double, ptr %6, i64 %.718.0483
  %.824 = load double, ptr %.823, align 8
  %.826 = getelementptr i32, ptr %arg.drive_columns, i64 %.718.0483
  %.827 = load i32, ptr %.826, align 4
  %.829 = sext i32 %.827 to i64
  %.830 = getelementptr double, ptr %.168, i64 %.829
  %.831 = load double, ptr %.830, align 8
  %.832 = fmul double %.824, %.831
  %.833 = fadd double %.818, %.832
  store double %.833, ptr %.817, align 8
  %exitcond.not = icmp eq i64 %.694, %.787
  br i1 %exitcond.not, label %B1252, label %B1148.if

B1298.endif.if:
  %.884 = icmp sgt i32 %.876, 0
  %.877 = load ptr, ptr %excinfo.6, align 8
  %.885 = select i1 %.884, ptr %.877, ptr undef
  store ptr %.885, ptr %excinfo, align 8
  br label %common.ret

B1298.endif.endif:
  store i64 0, ptr %.903, align 8
  %.907 = call i32 @lu_factor.10(ptr nonnull %.903, ptr nonnull %excinfo.7, i64 %.86, ptr %arg.lu_start, ptr %arg.lu_columns, ptr %arg.diagonal, ptr %.151, ptr %.134)
  switch i32 %.907, label %B1298.endif.endif.if [
    i32 -2, label %B1298.endif.endif.endif
    i32 0, label %B1298.endif.endif.endif
  ]

B1298.endif.endif.if:
  %.915 = icmp sgt i32 %.907, 0
  %.908 = load ptr, ptr %excinfo.7, align 8
  %.916 = select i1 %.915, ptr %.908, ptr undef
  store ptr %.916, ptr %excinfo, align 8
  br label %common.ret

B1298.endif.endif.endif:
  %.917 = load i64, ptr %.903, align 8
  %.929 = load i64, ptr %.928, align 8
  %.930 = add nsw i64 %.929, 1
  store i64 %.930, ptr %.928, align 8
  %.937 = icmp eq i64 %.917, 0
  br i1 %.937, label %B1546.if, label %B2558

B1546.if:
  %.964.0488 = phi i64 [ %.1034, %B2168.endif ], [ 0, %B1298.endif.endif.endif ]
  %.1034 = add nuw nsw i64 %.964.0488, 1
  %.1063 = icmp samesign ult i64 %.964.0488, 6
  br i1 %.1063, label %B1572, label %B1738

B1572.if:
  %.1081 = icmp sgt i32 %.1073, 0
  %.1074 = load ptr, ptr %excinfo.8, align 8
  %.1082 = select i1 %.1081, ptr %.1074, ptr undef
  store ptr %.1082, ptr %excinfo, align 8
  br label %common.ret

B1572.endif:
  %.1173485.not = icmp eq i64 %.964.0488, 0
  br i1 %.1173485.not, label %B1814, label %B1636.if.lr.ph

B1636.if.lr.ph:
  %.idx315 = shl nuw nsw i64 %.964.0488, 6
  %11 = getelementptr i8, ptr %arg.method, i64 %.idx315
  br label %B1636.if

B1636.if:
  %.1117.0486 = phi i64 [ 0, %B1636.if.lr.ph ], [ %.1186, %B1638.endif ]
  %.1216 = getelementptr double, ptr %11, i64 %.1117.0486
  %.1217 = load double, ptr %.1216, align 8
  %.1219 = mul nsw i64 %.1117.0486, %.86
  %.1221 = getelementptr double, ptr %arg.work, i64 %.1219
  store ptr null, ptr %.1224, align 8
  %.1228 = call i32 @add_scaled.15(ptr nonnull %.1224, ptr nonnull %excinfo.9, i64 %.86, double %.1217, ptr %.1221, ptr %.110)
  switch i32 %.1228, label %B1638.if [
    i32 -2, label %B1638.endif
    i32 0, label %B1638.endif
  ]

B1638.if:
  %.1236 = icmp sgt i32 %.1228, 0
  %.1229 = load ptr, ptr %excinfo.9, align 8
  %.1237 = select i1 %.1236, ptr %.1229, ptr undef
  store ptr %.1237, ptr %excinfo, align 8
  br label %common.ret

B1638.endif:
  %.1186 = add nuw nsw i64 %.1117.0486, 1
  %exitcond643.not = icmp eq i64 %.1186, %.964.0488
  br i1 %exitcond643.not, label %B1814, label %B1636.if

B1738.if:
  %.1275 = icmp sgt i32 %.1267, 0
  %.1268 = load ptr, ptr %excinfo.10, align 8
  %.1276 = select i1 %.1275, ptr %.1268, ptr undef
  store ptr %.1276, ptr %excinfo, align 8
  br label %common.ret

B1814.if:
  %.1304 = icmp sgt i32 %.1296, 0
  %.1297 = load ptr, ptr %excinfo.11, align 8
  %.1305 = select i1 %.1304, ptr %.1297, ptr undef
  store ptr %.1305, ptr %excinfo, align 8
  br label %common.ret

B1814.endif:
  %12 = getelementptr double, ptr %arg.method, i64 %.964.0488
  %.1319 = getelementptr i8, ptr %12, i64 1024
  %.1320 = load double, ptr %.1319, align 8
  %.1322 = fmul double %h.3.1, %.1320
  %.1324 = fadd double %until.2.1494, %.1322
  store double %.1324, ptr %.1327, align 8
  store ptr null, ptr %.1338, align 8
  %.1342 = call i32 @drive.6(ptr nonnull %.1338, ptr nonnull %excinfo.12, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.177, ptr %.185)
  switch i32 %.1342, label %B1814.endif.if [
    i32 -2, label %B1814.endif.endif
    i32 0, label %B1814.endif.endif
  ]

B1814.endif.if:
  %.1350 = icmp sgt i32 %.1342, 0
  %.1343 = load ptr, ptr %excinfo.12, align 8
  %.1351 = select i1 %.1350, ptr %.1343, ptr undef
  store ptr %.1351, ptr %excinfo, align 8
  br label %common.ret

B1814.endif.endif:
  store ptr null, ptr %.1372, align 8
  %.1376 = call i32 @residual.0(ptr nonnull %.1372, ptr nonnull %excinfo.13, ptr nonnull %arg.layout, ptr %arg.kernels, ptr %arg.idx, ptr %arg.rows, ptr %arg.numbers, ptr %arg.Y, ptr %.113, ptr %.177, ptr %.185)
  switch i32 %.1376, label %B1814.endif.endif.if [
    i32 -2, label %B1814.endif.endif.endif
    i32 0, label %B1814.endif.endif.endif
  ]

B1814.endif.endif.if:
  %.1384 = icmp sgt i32 %.1376, 0
  %.1377 = load ptr, ptr %excinfo.13, align 8
  %.1385 = select i1 %.1384, ptr %.1377, ptr undef
  store ptr %.1385, ptr %excinfo, align 8
  br label %common.ret

B1814.endif.endif.endif:
  %.idx314 = shl i64 %.964.0488, 6
  %13 = getelementptr i8, ptr %arg.method, i64 %.idx314
  %.1401 = getelementptr i8, ptr %13, i64 512
  store ptr null, ptr %.1409, align 8
  %.1413 = call i32 @combine.19(ptr nonnull %.1409, ptr nonnull %excinfo.14, i64 %.86, i64 %.964.0488, ptr %.1401, double %h.3.1, ptr %arg.mass, ptr %arg.work, ptr %.113, ptr %.117)
  switch i32 %.1413, label %B1814.endif.endif.endif.if [
    i32 -2, label %B1814.endif.endif.endif.endif
    i32 0, label %B1814.endif.endif.endif.endif
  ]

B1814.endif.endif.endif.if:
  %.1421 = icmp sgt i32 %.1413, 0
  %.1414 = load ptr, ptr %excinfo.14, align 8
  %.1422 = select i1 %.1421, ptr %.1414, ptr undef
  store ptr %.1422, ptr %excinfo, align 8
  br label %common.ret

B1814.endif.endif.endif.endif:
  %.1436 = getelementptr i8, ptr %12, i64 1088
  %.1437 = load double, ptr %.1436, align 8
  %.1439 = fmul double %h.3.1, %.1437
  %.1444 = fcmp une double %.1439, 0.000000e+00
  br i1 %.1444, label %B2132, label %B2168

B2132.if:
  %.1463 = icmp sgt i32 %.1455, 0
  %.1456 = load ptr, ptr %excinfo.15, align 8
  %.1464 = select i1 %.1463, ptr %.1456, ptr undef
  store ptr %.1464, ptr %excinfo, align 8
  br label %common.ret

B2168.if:
  %.1508 = icmp sgt i32 %.1500, 0
  %.1501 = load ptr, ptr %excinfo.16, align 8
  %.1509 = select i1 %.1508, ptr %.1501, ptr undef
  store ptr %.1509, ptr %excinfo, align 8
  br label %common.ret

B2168.endif:
  %exitcond644.not = icmp eq i64 %.1034, 8
  br i1 %exitcond644.not, label %B2256, label %B1546.if

B2256.if:
  %.1553 = icmp sgt i32 %.1545, 0
  %.1546 = load ptr, ptr %excinfo.17, align 8
  %.1554 = select i1 %.1553, ptr %.1546, ptr undef
  store ptr %.1554, ptr %excinfo, align 8
  br label %common.ret

B2256.endif:
  store ptr null, ptr %.1568, align 8
  %.1572 = call i32 @add_scaled.15(ptr nonnull %.1568, ptr nonnull %excinfo.18, i64 %.86, double 1.000000e+00, ptr %.1536, ptr %.117)
  switch i32 %.1572, label %B2256.endif.if [
    i32 -2, label %B2256.endif.endif
    i32 0, label %B2256.endif.endif
  ]

B2256.endif.if:
  %.1580 = icmp sgt i32 %.1572, 0
  %.1573 = load ptr, ptr %excinfo.18, align 8
  %.1581 = select i1 %.1580, ptr %.1573, ptr undef
  store ptr %.1581, ptr %excinfo, align 8
  br label %common.ret

B2256.endif.endif:
  %.1594 = load double, ptr %.1593, align 8
  %.1599 = fdiv double %h.3.1, %.1594
  store double 0.000000e+00, ptr %.1602, align 8
  %.1608 = call i32 @numba.13(ptr nonnull %.1602, ptr nonnull %excinfo.19, double 1.000000e+00, double %.1599)
  switch i32 %.1608, label %B2256.endif.endif.endif.if [
    i32 -2, label %B2256.endif.endif.endif.endif
    i32 0, label %B2256.endif.endif.endif.endif
  ]

B2256.endif.endif.endif.if:
  %.1616 = icmp sgt i32 %.1608, 0
  %.1609 = load ptr, ptr %excinfo.19, align 8
  %.1617 = select i1 %.1616, ptr %.1609, ptr undef
  store ptr %.1617, ptr %excinfo, align 8
  br label %common.ret

B2256.endif.endif.endif.endif:
  %.1618 = load double, ptr %.1602, align 8
  %.1631 = load double, ptr %arg.settings, align 8
  store double 0.000000e+00, ptr %.1637, align 8
  %.1641 = call i32 @step_error.20(ptr nonnull %.1637, ptr nonnull %excinfo.20, i64 %.86, i64 %arg.tested, ptr %arg.y, ptr %.117, ptr %.1536, ptr %arg.powers, double %.1618, double %.1631)
  switch i32 %.1641, label %B2256.endif.endif.endif.endif.if [
    i32 -2, label %B2256.endif.endif.endif.endif.endif
    i32 0, label %B2256.endif.endif.endif.endif.endif
  ]

B2256.endif.endif.endif.endif.if:
  %.1649 = icmp sgt i32 %.1641, 0
  %.1642 = load ptr, ptr %excinfo.20, align 8
  %.1650 = select i1 %.1649, ptr %.1642, ptr undef
  store ptr %.1650, ptr %excinfo, align 8
  br label %common.ret

B2256.endif.endif.endif.endif.endif:
  %.1651 = load double, ptr %.1637, align 8
  br label %B2558

B2570.if:
  %.1698 = icmp sgt i32 %.1690, 0
  %.1691 = load ptr, ptr %excinfo.21, align 8
  %.1699 = select i1 %.1698, ptr %.1691, ptr undef
  store ptr %.1699, ptr %excinfo, align 8
  br label %common.ret

B2570.endif:
  %.1700 = load double, ptr %.1686, align 8
  %.1713 = fmul double %h.3.1, %.1700
  store double %.1713, ptr %.330, align 8
  %.1724 = load double, ptr %.1723, align 8
  %.1725 = fcmp olt double %.1713, %.1724
  br i1 %.1725, label %B2748, label %B3551

B2942.if:
  %.1961 = icmp sgt i32 %.1953, 0
  %.1954 = load ptr, ptr %excinfo.22, align 8
  %.1962 = select i1 %.1961, ptr %.1954, ptr undef
  store ptr %.1962, ptr %excinfo, align 8
  br label %common.ret

B2942.endif:
  store i64 %stop.3.2, ptr %arg.counts, align 8
  br label %B3152

B3152.if:
  %.2007 = icmp sgt i32 %.1999, 0
  %.2000 = load ptr, ptr %excinfo.23, align 8
  %.2008 = select i1 %.2007, ptr %.2000, ptr undef
  store ptr %.2008, ptr %excinfo, align 8
  br label %common.ret

B3152.endif:
  store ptr null, ptr %.2026, align 8
  %.2030 = call i32 @copy.14(ptr nonnull %.2026, ptr nonnull %excinfo.24, i64 %.86, ptr %.117, ptr %arg.y)
  switch i32 %.2030, label %B3152.endif.if [
    i32 -2, label %B3152.endif.endif
    i32 0, label %B3152.endif.endif
  ]

B3152.endif.if:
  %.2038 = icmp sgt i32 %.2030, 0
  %.2031 = load ptr, ptr %excinfo.24, align 8
  %.2039 = select i1 %.2038, ptr %.2031, ptr undef
  store ptr %.2039, ptr %excinfo, align 8
  br label %common.ret

B3152.endif.endif:
  store double %until.2.1, ptr %arg.state, align 8
  br i1 %.347, label %B3290, label %B3418

B3290.if:
  %.2164 = icmp sgt i32 %.2156, 0
  %.2157 = load ptr, ptr %excinfo.25, align 8
  %.2165 = select i1 %.2164, ptr %.2157, ptr undef
  store ptr %.2165, ptr %excinfo, align 8
  br label %common.ret

B3290.endif:
  %.2181 = getelementptr i8, ptr %arg.settings, i64 32
  %.2182 = load double, ptr %.2181, align 8
  %.2188 = fdiv double 1.000000e+00, %.2182
  store double 0.000000e+00, ptr %.2192, align 8
  %.2198 = call i32 @numba.13(ptr nonnull %.2192, ptr nonnull %excinfo.26, double %.2009, double %.2188)
  switch i32 %.2198, label %B3290.endif.endif.if [
    i32 -2, label %B3290.endif.endif.endif
    i32 0, label %B3290.endif.endif.endif
  ]

B3290.endif.endif.if:
  %.2206 = icmp sgt i32 %.2198, 0
  %.2199 = load ptr, ptr %excinfo.26, align 8
  %.2207 = select i1 %.2206, ptr %.2199, ptr undef
  store ptr %.2207, ptr %excinfo, align 8
  br label %common.ret

B3290.endif.endif.endif:
  %.2208 = load double, ptr %.2192, align 8
  %.2220 = fmul double %.2166, %.2208
  store double %.2220, ptr %.330, align 8
  store i64 0, ptr %retptr, align 8
  br label %common.ret

B3418.if:
  %.2256 = icmp sgt i32 %.2248, 0
  %.2249 = load ptr, ptr %excinfo.27, align 8
  %.2257 = select i1 %.2256, ptr %.2249, ptr undef
  store ptr %.2257, ptr %excinfo, align 8
  br label %common.ret

B3418.endif:
  %.2258 = load double, ptr %.2242, align 8
  store double %.2258, ptr %.330, align 8
  store double 0.000000e+00, ptr %.2274, align 8
  %.2280 = call i32 @numba.18(ptr nonnull %.2274, ptr nonnull %excinfo.28, double %error.2.1, double 1.000000e-04)
  switch i32 %.2280, label %B3418.endif.if [
    i32 -2, label %B3418.endif.endif
    i32 0, label %B3418.endif.endif
  ]

B3418.endif.if:
  %.2288 = icmp sgt i32 %.2280, 0
  %.2281 = load ptr, ptr %excinfo.28, align 8
  %.2289 = select i1 %.2288, ptr %.2281, ptr undef
  store ptr %.2289, ptr %excinfo, align 8
  br label %common.ret

B3418.endif.endif:
  %.2290 = load double, ptr %.2274, align 8
  store double %.2290, ptr %.1988, align 8
  br label %B3551
}

define internal i32 @copy.14(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.x, ptr noalias %arg.y) {
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

define internal i32 @add_scaled.15(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, double %arg.factor, ptr noalias %arg.x, ptr noalias %arg.y) {
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
  %.140 = fmul double %arg.factor, %.138
  %.141 = fadd double %.135, %.140
  store double %.141, ptr %.134, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.108
  br i1 %exitcond.not, label %B90, label %B34.if
}

define internal i32 @step_factor.16(ptr noalias %retptr, ptr noalias %excinfo, double %arg.error, double %arg.before, double %arg.order, ptr noalias %arg.settings) noinline {
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
  %.17 = fsub double %arg.error, %arg.error
  %.18 = fcmp ord double %.17, 0.000000e+00
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
  %.42 = call i32 @numba.18(ptr nonnull %.36, ptr nonnull %excinfo.1, double %arg.error, double 1.000000e-10)
  %.52 = load double, ptr %.36, align 8
  switch i32 %.42, label %B70.if [
    i32 -2, label %B70.endif
    i32 0, label %B70.endif
  ]

B114:
  %.75 = getelementptr i8, ptr %arg.settings, i64 32
  %.76 = load double, ptr %.75, align 8
  %.81 = fdiv double -1.000000e+00, %arg.order
  %.85 = call double @llvm.pow.f64(double %.52, double %.81)
  %.88 = fmul double %.85, %.76
  br label %B250

B160:
  %.94 = getelementptr i8, ptr %arg.settings, i64 56
  %.95 = load double, ptr %.94, align 8
  %.97 = getelementptr i8, ptr %arg.settings, i64 32
  %.98 = load double, ptr %.97, align 8
  %.103 = fdiv double 1.000000e+00, %arg.order
  %.106 = fsub double %.95, %.103
  %.108 = call double @llvm.pow.f64(double %.52, double %.106)
  %.111 = fmul double %.98, %.108
  %.112 = fneg double %.95
  %.114 = call double @llvm.pow.f64(double %arg.before, double %.112)
  %.117 = fmul double %.114, %.111
  br label %B250

B250:
  %wanted.2.0 = phi double [ %.88, %B114 ], [ %.117, %B160 ]
  %.122 = getelementptr i8, ptr %arg.settings, i64 40
  %.123 = load double, ptr %.122, align 8
  %.125 = getelementptr i8, ptr %arg.settings, i64 48
  %.126 = load double, ptr %.125, align 8
  store double 0.000000e+00, ptr %.132, align 8
  %.138 = call i32 @numba.18(ptr nonnull %.132, ptr nonnull %excinfo.2, double %.126, double %wanted.2.0)
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
  %.70 = fcmp oeq double %arg.before, 1.000000e+00
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
  %.168 = call i32 @numba.13(ptr nonnull %.162, ptr nonnull %excinfo.3, double %.123, double %.148)
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

define internal i32 @dense_output.17(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, ptr noalias %arg.y, ptr noalias %arg.after, ptr noalias %arg.stages, ptr noalias %arg.method, double %arg.time, double %arg.until, ptr noalias %arg.edges, i64 %arg.count, ptr noalias %arg.outputs, ptr noalias %arg.inner) noinline {
entry:
  %.169 = alloca double, align 8
  store double 0.000000e+00, ptr %.169, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.214 = alloca ptr, align 8
  store ptr null, ptr %.214, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  %.512 = alloca ptr, align 8
  store ptr null, ptr %.512, align 8
  %excinfo.3 = alloca ptr, align 8
  store ptr null, ptr %excinfo.3, align 8
  %.117157.not = icmp slt i64 %arg.count, 1
  br i1 %.117157.not, label %B628, label %B36.if.lr.ph

B36.if.lr.ph:
  %.162 = fsub double %arg.until, %arg.time
  %storemerge145 = call i64 @llvm.smax.i64(i64 %arg.n, i64 0)
  %.321149.not = icmp slt i64 %arg.n, 1
  %.621154.not = icmp slt i64 %arg.n, 1
  %0 = shl nuw i64 %storemerge145, 3
  br label %B36.if

B152:
  store ptr null, ptr %.214, align 8
  %.218 = call i32 @copy.14(ptr nonnull %.214, ptr nonnull %excinfo.2, i64 %arg.n, ptr %arg.after, ptr %.201)
  switch i32 %.218, label %B152.if [
    i32 -2, label %B629
    i32 0, label %B629
  ]

B188:
  br i1 %.321149.not, label %B274.if.preheader, label %B218.if.preheader

B274.if.preheader:
  br label %B274.if

B218.if.preheader:
  call void @llvm.memset.p0.i64(ptr align 8 %arg.inner, i8 0, i64 %0, i1 false)
  br label %B274.if.preheader

B530.preheader:
  br i1 %.621154.not, label %B629, label %B530.if.lr.ph

B530.if.lr.ph:
  %.660 = fsub double 1.000000e+00, %.185
  br label %B530.if

common.ret:
  %common.ret.op = phi i32 [ 0, %B628 ], [ %.516, %B276.if ], [ %.218, %B152.if ], [ %.175, %B38.endif.if ]
  ret i32 %common.ret.op

B628:
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B629:
  %exitcond165.not = icmp eq i64 %.130, %arg.count
  br i1 %exitcond165.not, label %B628, label %B36.if

B36.if:
  %.58.0158 = phi i64 [ 0, %B36.if.lr.ph ], [ %.130, %B629 ]
  %.130 = add nuw nsw i64 %.58.0158, 1
  %.156 = getelementptr double, ptr %arg.edges, i64 %.58.0158
  %.157 = load double, ptr %.156, align 8
  %.159 = fsub double %.157, %arg.time
  %.166 = fdiv double %.159, %.162
  store double 0.000000e+00, ptr %.169, align 8
  %.175 = call i32 @numba.13(ptr nonnull %.169, ptr nonnull %excinfo.1, double %.166, double 1.000000e+00)
  %.185 = load double, ptr %.169, align 8
  switch i32 %.175, label %B38.endif.if [
    i32 -2, label %B38.endif.endif
    i32 0, label %B38.endif.endif
  ]

B38.endif.if:
  %.183 = icmp sgt i32 %.175, 0
  %.176 = load ptr, ptr %excinfo.1, align 8
  %.184 = select i1 %.183, ptr %.176, ptr undef
  store ptr %.184, ptr %excinfo, align 8
  br label %common.ret

B38.endif.endif:
  %.199 = mul nsw i64 %.58.0158, %arg.n
  %.201 = getelementptr double, ptr %arg.outputs, i64 %.199
  %.206 = fcmp oeq double %.185, 1.000000e+00
  br i1 %.206, label %B152, label %B188

B152.if:
  %.226 = icmp sgt i32 %.218, 0
  %.219 = load ptr, ptr %excinfo.2, align 8
  %.227 = select i1 %.226, ptr %.219, ptr undef
  store ptr %.227, ptr %excinfo, align 8
  br label %common.ret

B274.if:
  %.390.0152 = phi i64 [ %.459, %B276.endif ], [ 0, %B274.if.preheader ]
  %1 = getelementptr double, ptr %arg.method, i64 %.390.0152
  %.487 = getelementptr i8, ptr %1, i64 1216
  %.488 = load double, ptr %.487, align 8
  %.493 = getelementptr i8, ptr %1, i64 1280
  %.494 = load double, ptr %.493, align 8
  %.496 = fmul double %.185, %.494
  %.497 = fadd double %.488, %.496
  %.501 = getelementptr i8, ptr %1, i64 1152
  %.502 = load double, ptr %.501, align 8
  %.504 = fmul double %.185, %.497
  %.505 = fadd double %.502, %.504
  %.507 = mul nsw i64 %.390.0152, %arg.n
  %.509 = getelementptr double, ptr %arg.stages, i64 %.507
  store ptr null, ptr %.512, align 8
  %.516 = call i32 @add_scaled.15(ptr nonnull %.512, ptr nonnull %excinfo.3, i64 %arg.n, double %.505, ptr %.509, ptr %arg.inner)
  switch i32 %.516, label %B276.if [
    i32 -2, label %B276.endif
    i32 0, label %B276.endif
  ]

B276.if:
  %.524 = icmp sgt i32 %.516, 0
  %.517 = load ptr, ptr %excinfo.3, align 8
  %.525 = select i1 %.524, ptr %.517, ptr undef
  store ptr %.525, ptr %excinfo, align 8
  br label %common.ret

B276.endif:
  %.459 = add nuw nsw i64 %.390.0152, 1
  %exitcond.not = icmp eq i64 %.459, 8
  br i1 %exitcond.not, label %B530.preheader, label %B274.if

B530.if:
  %.565.0155 = phi i64 [ 0, %B530.if.lr.ph ], [ %.634, %B530.if ]
  %.634 = add nuw nsw i64 %.565.0155, 1
  %.662 = getelementptr double, ptr %arg.y, i64 %.565.0155
  %.663 = load double, ptr %.662, align 8
  %.664 = fmul double %.660, %.663
  %.666 = getelementptr double, ptr %arg.after, i64 %.565.0155
  %.667 = load double, ptr %.666, align 8
  %.671 = getelementptr double, ptr %arg.inner, i64 %.565.0155
  %.672 = load double, ptr %.671, align 8
  %.673 = fmul double %.660, %.672
  %.674 = fadd double %.667, %.673
  %.676 = fmul double %.185, %.674
  %.677 = fadd double %.664, %.676
  %.679 = getelementptr double, ptr %.201, i64 %.565.0155
  store double %.677, ptr %.679, align 8
  %exitcond164.not = icmp eq i64 %arg.n, %.634
  br i1 %exitcond164.not, label %B629, label %B530.if
}

define internal i32 @numba.18(ptr noalias %retptr, ptr noalias %excinfo, double %arg.x.0, double %arg.x.1) {
entry:
  %.10 = fcmp ogt double %arg.x.1, %arg.x.0
  %.11 = select i1 %.10, double %arg.x.1, double %arg.x.0
  store double %.11, ptr %retptr, align 8
  ret i32 0
}

define internal i32 @numba.13(ptr noalias %retptr, ptr noalias %excinfo, double %arg.x.0, double %arg.x.1) {
entry:
  %.10 = fcmp olt double %arg.x.1, %arg.x.0
  %.11 = select i1 %.10, double %arg.x.1, double %arg.x.0
  store double %.11, ptr %retptr, align 8
  ret i32 0
}

define internal i32 @combine.19(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, i64 %arg.count, ptr noalias %arg.weights, double %arg.h, ptr noalias %arg.mass, ptr noalias %arg.stages, ptr noalias %arg.right, ptr noalias %arg.pull) noinline {
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
  %.311 = call i32 @add_scaled.15(ptr nonnull %.307, ptr nonnull %excinfo.1, i64 %arg.n, double %.300, ptr %.304, ptr %arg.pull)
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
  %.469 = fmul double %.465, %.468
  %.474 = fdiv double %.469, %arg.h
  %.475 = fadd double %.462, %.474
  store double %.475, ptr %.461, align 8
  %exitcond123.not = icmp eq i64 %arg.n, %.435
  br i1 %exitcond123.not, label %B288, label %B214.if
}

define internal i32 @step_error.20(ptr noalias %retptr, ptr noalias %excinfo, i64 %arg.n, i64 %arg.tested, ptr noalias %arg.y, ptr noalias %arg.after, ptr noalias %arg.apart, ptr noalias %arg.powers, double %arg.lead, double %arg.tolerance) noinline {
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
  %.167 = fsub double %.164, %.164
  %.168 = fcmp ord double %.167, 0.000000e+00
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
  %.342 = call double @llvm.fabs.f64(double %.341)
  %.345 = getelementptr double, ptr %arg.after, i64 %.229.0138
  %.346 = load double, ptr %.345, align 8
  %.347 = call double @llvm.fabs.f64(double %.346)
  store double 0.000000e+00, ptr %.350, align 8
  %.356 = call i32 @numba.18(ptr nonnull %.350, ptr nonnull %excinfo.1, double %.342, double %.347)
  switch i32 %.356, label %B254.if [
    i32 -2, label %B254.endif
    i32 0, label %B254.endif
  ]

B446:
  %.408 = call double @llvm.pow.f64(double %arg.lead, double %.333)
  %.410 = fmul double %.408, %.387
  br label %B474

B474:
  %error.3.1 = phi double [ %.410, %B446 ], [ %.387, %B254.endif ]
  store double 0.000000e+00, ptr %.424, align 8
  %.430 = call i32 @numba.18(ptr nonnull %.424, ptr nonnull %excinfo.2, double %worst.3.0140, double %error.3.1)
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
  %.158 = fsub double %.157, %.157
  %.159 = fcmp ord double %.158, 0.000000e+00
  br i1 %.159, label %B94, label %B146

B206.if:
  %worst.3.0140 = phi double [ %worst.4.1, %B506 ], [ 0.000000e+00, %B176 ]
  %.229.0138 = phi i64 [ %.298, %B506 ], [ 0, %B176 ]
  %.298 = add nuw nsw i64 %.229.0138, 1
  %.332 = getelementptr double, ptr %arg.powers, i64 %.229.0138
  %.333 = load double, ptr %.332, align 8
  %.334 = fcmp ueq double %.333, 0x7FF0000000000000
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
  %.380 = call double @llvm.fabs.f64(double %.379)
  %.381 = fadd double %.366, 1.000000e+00
  %.383 = fmul double %arg.tolerance, %.381
  %.387 = fdiv double %.380, %.383
  %.399 = fcmp une double %.333, 0.000000e+00
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
  %.605 = call double @llvm.fabs.f64(double %.604)
  %.607 = getelementptr double, ptr %arg.after, i64 %.508.0142
  %.608 = load double, ptr %.607, align 8
  %.610 = getelementptr double, ptr %arg.y, i64 %.508.0142
  %.611 = load double, ptr %.610, align 8
  %.612 = fsub double %.608, %.611
  %.613 = call double @llvm.fabs.f64(double %.612)
  %.614 = fadd double %.613, 1.000000e+00
  %.616 = fmul double %arg.tolerance, %.614
  %.620 = fdiv double %.605, %.616
  store double 0.000000e+00, ptr %.624, align 8
  %.630 = call i32 @numba.18(ptr nonnull %.624, ptr nonnull %excinfo.3, double %worst.5.0144, double %.620)
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

declare i64 @llvm.smax.i64(i64, i64)

declare i64 @llvm.smin.i64(i64, i64)

declare void @llvm.memset.p0.i64(ptr, i8, i64, i1 immarg)

declare void @llvm.memcpy.p0.p0.i64(ptr noalias, ptr noalias, i64, i1 immarg)
