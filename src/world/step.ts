/** Simulated time per step of the world, in µs. Chosen: steps of 2 ms and 1 ms drive the same way within 0.1 %. */
export const STEP_US = 4000;

/** The same in seconds. */
export const STEP_S = STEP_US / 1e6;
