(* How far the minimax polynomials of host_sim/figures/prove/sine.cpp are from sine and cosine of w eighths of a turn. *)
From Coq Require Import Reals.
From Interval Require Import Tactic.
Open Scope R_scope.

Lemma near_sine : forall w, 0 <= w <= 1 ->
  Rabs (sin (PI / 4 * w) - w * (0.785398163378806052 - w * w * (0.080745511815160135 - w * w *
    (0.00249039247884497959 - w * w * (0.0000365714176659238459 - w * w * 3.08563416692922074e-7))))) <= 1.7e-12.
Proof. intros; interval with (i_taylor w, i_bisect w, i_degree 14, i_prec 80, i_depth 20). Qed.

Lemma near_cosine : forall w, 0 <= w <= 1 ->
  Rabs (cos (PI / 4 * w) - (1 - w * w * (0.308425135838371722 - w * w * (0.015854327751876864 - w * w *
    (0.000325942007949781913 - w * w * 3.53133465543485538e-6))))) <= 5.4e-11.
Proof. intros; interval with (i_taylor w, i_bisect w, i_degree 14, i_prec 80, i_depth 20). Qed.
