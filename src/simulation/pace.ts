/**
 * The phase of a run. `ready`: everything at the start. `stopped`: the last picture stays. `killed`: likewise, ended by
 * force. `failed`: broken inside or never started.
 */
export type RunPhase = 'ready' | 'starting' | 'running' | 'paused' | 'stopping' | 'stopped' | 'killed' | 'failed';

/** All speeds, slowest first: simulated seconds per wall second; `max`: as fast as the machine can. */
export const SPEEDS = [0.25, 0.5, 1, 2, 4, 8, 'max'] as const;

/** How fast simulated time runs against the wall clock. */
export type Speed = (typeof SPEEDS)[number];
