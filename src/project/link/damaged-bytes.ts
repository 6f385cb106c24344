/** What is read does not fit what was written. */
export class DamagedBytes extends Error {}
