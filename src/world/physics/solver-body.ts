import type { Body } from './planck';

/**
 * What planck 1.5.0 keeps on a body while it solves a step. Joints work on it directly; it is not in planck's own types,
 * which is one more reason why the version is pinned.
 */
export interface SolverBody {
  readonly c_position: { readonly a: number };
  readonly c_velocity: { readonly v: { x: number; y: number }; w: number };
}

/** The solver's view of a body. */
export const solverBodyOf = (body: Body): SolverBody => body as unknown as SolverBody;
