/** What this dialect lets in and out at most. Chosen: far beyond what a host needs, little for a tablet. */
export const limits = {
  /** Commands that wait for the one before them; more are refused as `busy`. */
  waitingCommands: 200,
  idCharacters: 100,
  nameCharacters: 100,
  /** One piece of text for the serial line. */
  serialCharacters: 10_000,
  /** One radio packet: micropython-microbit-v2 knows no longer one. */
  radioBytes: 251,
  labels: 30,
  labelCharacters: 200,
  snapshotHz: 60,
  /** Output of a program that prints without end, likewise its packets and its rows: what comes faster is left out and counted. */
  outputCharactersPerSecond: 200_000,
  /** Values and characters of a message that brings a project, a course or an edit. */
  documentValues: 500_000,
  documentCharacters: 14_000_000,
  /** The same for every other message but files; a few kB would do. */
  values: 2_000,
  characters: 100_000,
  /** Objects and lists within each other. */
  depth: 40,
  /** An English sentence to a host; values in it may be long. */
  messageCharacters: 400,
} as const;
