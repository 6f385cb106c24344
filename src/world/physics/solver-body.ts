import type { Body } from './planck';

/** A place or a speed that the solver changes. */
export interface Point {
  x: number;
  y: number;
}

/**
 * Properties of a body that planck 1.5.0 uses to solve a step, and those behind its transform. Joints and quiet steps work
 * on it directly; it is not in planck's own types, which is one more reason why the version is pinned.
 */
export interface SolverBody {
  readonly c_position: { readonly c: Point; a: number };
  readonly c_velocity: { readonly v: Point; w: number };
  readonly m_sweep: { readonly c: Point; readonly c0: Point; a: number; a0: number };
}

/** The solver's view of a body. */
export const solverBodyOf = (body: Body): SolverBody => body as unknown as SolverBody;

/** Puts a body somewhere and keeps its full turns, which the engine's own `setTransform` removes. Speeds stay. */
export function moveBody(body: Body, x: number, y: number, angle: number): void {
  body.setTransform({ x, y }, angle);
  const { m_sweep: sweep } = solverBodyOf(body);
  sweep.a0 = angle;
  sweep.a = angle;
}
