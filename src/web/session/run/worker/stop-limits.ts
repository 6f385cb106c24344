/*
 * Stop should answer within 100 ms: the program is interrupted, cleans up, and the worker reports its end. Only a
 * program that is inside one long C call does not hear the interrupt; then the page ends the worker.
 */

/** Time that a stopped program gets for its `finally`, in ms of wall time. */
export const FAREWELL_MS = 50;

/** Time that Stop waits for the worker's answer before the page ends the worker, in ms of wall time. */
export const STOP_ANSWER_MS = 500;
