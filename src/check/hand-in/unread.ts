/** Why something that was handed in cannot be read. */
export interface Unread {
  readonly code: UnreadCode;
  /** Values for the sentence about it. */
  readonly params: Readonly<Record<string, string | number>>;
}

/** The codes of what cannot be read, as reports have them. */
export const unreadCodes = [
  // files
  ...(['kind', 'not-text', 'project', 'newer', 'course', 'tournament', 'large', 'gone', 'slow'] as const),
  // a board's file
  ...(['hex-line', 'hex-damaged', 'hex-makecode', 'hex-other', 'hex-empty'] as const),
  // folders
  ...(['no-main', 'several', 'many-files'] as const),
  // links
  ...(['link', 'newer-link', 'no-work', 'no-link', 'many-links'] as const),
  // zips
  ...([
    'zip',
    'zip-list',
    'zip-many',
    'zip-much',
    'zip-twice',
    'zip-file',
    'zip-locked',
    'zip-large',
    'zip-way',
    'zip-bomb',
  ] as const),
  // an error of ours, and a part of the page that did not come
  ...(['broken', 'unloaded'] as const),
] as const;
export type UnreadCode = (typeof unreadCodes)[number];

/** Returns a read failure in the place of a hand-in. */
export const unread = (code: UnreadCode, params: Unread['params'] = {}): { readonly problem: Unread } => ({
  problem: { code, params },
});
