/** Limits of this dialect in both directions. Chosen: far beyond what a host needs, little for a tablet. */
export const limits = {
  /** Commands that wait; more are refused as `busy`. */
  waitingCommands: 200,
  idCharacters: 100,
  nameCharacters: 100,
  /** One piece of text for the serial line. */
  serialCharacters: 10_000,
  /** One radio packet: the maximum of micropython-microbit-v2. */
  radioBytes: 251,
  labels: 30,
  labelCharacters: 200,
  /** Maximum per program. */
  breakPoints: 500,
  snapshotHz: 60,
  /** Rate of a program's output, and of its packets and its rows: the rest is left out and counted. */
  outputCharactersPerSecond: 200_000,
  /** Values and characters of a message with a project, a course or an edit. */
  documentValues: 500_000,
  documentCharacters: 14_000_000,
  /** The same for every other message except files; a few kB would do. */
  values: 2_000,
  characters: 100_000,
  /** Nesting depth of objects and lists. */
  depth: 40,
  /** An English sentence for a host; values in it may be long. */
  messageCharacters: 400,
} as const;
