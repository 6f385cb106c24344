import type { HexBoard } from '#hex/firmware';

/** The kind of chip on a board, as its interface tells: the Calliope mini 3 is a `V2`. */
export type BoardVersion = 'V1' | 'V2';

/** The problems on the way by USB. Plain data; the words are in `words`. */
export type UsbProblem =
  /** Another tab or program has the board. */
  | { readonly kind: 'in-use' }
  /** Its interface chip's firmware is too old for WebUSB. */
  | { readonly kind: 'old-interface' }
  /** It is neither a micro:bit nor a Calliope mini 3. */
  | { readonly kind: 'not-a-board' }
  /** The browser has no WebUSB. */
  | { readonly kind: 'browser' }
  /** The frame around the page does not allow it. */
  | { readonly kind: 'frame' }
  /** The cable came out. `isTouched`: in the middle of the transfer. */
  | { readonly kind: 'unplugged'; readonly isTouched: boolean }
  /** It does not answer any more. */
  | { readonly kind: 'silent' }
  /** It is an older or newer board than the one that was chosen, and no MicroPython for it is at hand. */
  | { readonly kind: 'other-board'; readonly found: HexBoard }
  /** The program needs more room than there is. */
  | { readonly kind: 'too-large'; readonly missingBytes: number; readonly large: readonly string[] }
  /** A file has a name that a board cannot hold. */
  | { readonly kind: 'name'; readonly name: string }
  /** The part that writes it did not load: no connection, most likely. */
  | { readonly kind: 'not-written' }
  /** Stopped by the pupil in the middle: only a part of the program is on the board. */
  | { readonly kind: 'stopped' }
  /** Something else went wrong on the line. */
  | { readonly kind: 'line' };

/** Ends the transfer from within the making of its hex. */
export class HexError extends Error {
  constructor(readonly problem: UsbProblem) {
    super(problem.kind);
  }
}

/** The codes of the library's errors, version 1.0.0, as far as USB has them. */
const byCode: Readonly<Record<string, UsbProblem>> = {
  'device-in-use': { kind: 'in-use' },
  'firmware-update-required': { kind: 'old-interface' },
  unsupported: { kind: 'browser' },
  'not-connected': { kind: 'unplugged', isTouched: false },
  'device-disconnected': { kind: 'unplugged', isTouched: true },
  timeout: { kind: 'silent' },
};

/**
 * The problem that an error of the library tells.
 *
 * @returns `null` when nobody needs to be told: no board was chosen
 */
export function usbProblem(error: unknown): UsbProblem | null {
  if (error instanceof HexError) return error.problem;
  const { code, message } = error as { readonly code?: unknown; readonly message?: unknown };
  if (code === 'no-device-selected') return null;
  const text = String(message);
  if (/permissions policy|SecurityError/i.test(text)) return { kind: 'frame' };
  if (/recogni[sz]e the Board ID/i.test(text)) return { kind: 'not-a-board' };
  return byCode[String(code)] ?? { kind: 'line' };
}
