/** The input does not fit what a writer would have written. */
export class DamagedBytes extends Error {}
