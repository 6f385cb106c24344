import type { TextKey } from '../../../kit/i18n';

/**
 * Reason for a missing VM: it does not arrive, something else arrives instead, or a policy of the page or the computer
 * forbids compiling.
 */
export type FirmwareTrouble = 'absent' | 'foreign' | 'forbidden';

/** The VM could not be loaded or compiled. */
export class FirmwareError extends Error {
  constructor(
    readonly trouble: FirmwareTrouble,
    options: { readonly cause?: unknown } = {},
  ) {
    super(`The VM is ${trouble}.`, options);
  }
}

/** The page's texts for it. */
const SAID = {
  absent: 'notice.firmware',
  foreign: 'notice.firmwareForeign',
  forbidden: 'notice.firmwarePolicy',
} as const satisfies Readonly<Record<FirmwareTrouble, TextKey>>;

/** Key of a text that says why there is no VM. */
export type TroubleKey = (typeof SAID)[FirmwareTrouble];

/** Reason for which a run could not get its VM, as far as it is known. */
export const troubleOf = (error: unknown): FirmwareTrouble =>
  error instanceof FirmwareError ? error.trouble : 'absent';

/** The key of the page's text for it. */
export const troubleKey = (error: unknown): TroubleKey => SAID[troubleOf(error)];

/** "\0asm" and the version: how every compiled file begins, and the shortest one. */
const SHORTEST = Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0);

/** True if the browser may compile anything at all. */
export function mayCompile(): boolean {
  try {
    return new WebAssembly.Module(SHORTEST) instanceof WebAssembly.Module;
  } catch {
    return false;
  }
}

/** True if bytes begin like a compiled file. */
export const isCompiled = (bytes: Uint8Array): boolean => SHORTEST.every((byte, place) => bytes[place] === byte);
