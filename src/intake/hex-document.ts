import { unread, type Unread } from '#check/hand-in/unread';
import type { HexProblem } from '#hex/firmware';
import type { OpenedHex } from '#hex/open';
import { MAIN } from '#project/project';
import { unreadable, type HexDocument, type Unreadable } from './document';

/** Reads a board's file: the program in it. What reads it is fetched when the first one comes. Never rejects. */
export async function hexDocument(bytes: Uint8Array): Promise<HexDocument | Unreadable> {
  try {
    const { openHex } = await import('#hex/open');
    const opened = openHex(new TextDecoder().decode(bytes));
    if ('problem' in opened) return unreadable(unreadHex(opened.problem));
    const why = whyEmpty(opened);
    if (why !== null) return unreadable(why);
    const { hex, files, ours, unfit } = opened;
    const own = files.length === 1 ? files.map(({ text }) => ({ name: MAIN, text })) : files;
    return { kind: 'hex', files: own, boards: hex.boards, ours, unfit };
  } catch (error) {
    return unreadable(unread('gone', { problem: error instanceof Error ? error.message : String(error) }).problem);
  }
}

/** Why there is no program in a hex that was read; `null`: there is one. */
export function whyEmpty({ hex, files }: OpenedHex): Unread | null {
  if (hex.made === 'makecode') return unread('hex-makecode').problem;
  if (hex.made === 'unknown') return unread('hex-other').problem;
  const isProgram = files.length === 1 || files.some(({ name }) => name === MAIN);
  return isProgram ? null : unread('hex-empty').problem;
}

/** Why a hex cannot be read, as reports have it. */
export function unreadHex({ code, line = 0 }: HexProblem): Unread {
  switch (code) {
    case 'line':
      return unread('hex-line', { line }).problem;
    case 'makecode':
      return unread('hex-makecode').problem;
    case 'no-python':
      return unread('hex-other').problem;
    default:
      return unread('hex-damaged').problem;
  }
}
