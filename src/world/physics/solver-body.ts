import type { Body } from './planck';

/**
 * What planck 1.5.0 keeps on a body while it solves a step, and the angle behind its transform. Joints work on it
 * directly; it is not in planck's own types, which is one more reason why the version is pinned.
 */
export interface SolverBody {
  readonly c_position: { readonly a: number };
  readonly c_velocity: { readonly v: { x: number; y: number }; w: number };
  readonly m_sweep: { a0: number; a: number };
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
