import type { TextKey } from '../../page/i18n';

/**
 * Why there is no VM: it does not come, something else comes in its place, or a policy of the page or the computer forbids to
 * compile any.
 */
export type FirmwareTrouble = 'absent' | 'foreign' | 'forbidden';

/** The VM cannot be had. */
export class FirmwareError extends Error {
  constructor(
    readonly trouble: FirmwareTrouble,
    options: { readonly cause?: unknown } = {},
  ) {
    super(`The VM is ${trouble}.`, options);
  }
}

/** What the page says about it. */
const SAID = {
  absent: 'notice.firmware',
  foreign: 'notice.firmwareForeign',
  forbidden: 'notice.firmwarePolicy',
} as const satisfies Readonly<Record<FirmwareTrouble, TextKey>>;

/** The texts of why there is no VM. */
export type TroubleKey = (typeof SAID)[FirmwareTrouble];

/** Why a run could not get its VM, as far as is known. */
export const troubleOf = (error: unknown): FirmwareTrouble =>
  error instanceof FirmwareError ? error.trouble : 'absent';

/** The same for the page. */
export const troubleKey = (error: unknown): TroubleKey => SAID[troubleOf(error)];

/** "\0asm" and the version: how every compiled file begins, and the shortest one. */
const SHORTEST = Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0);

/** Whether the browser may compile anything at all. */
export function mayCompile(): boolean {
  try {
    return new WebAssembly.Module(SHORTEST) instanceof WebAssembly.Module;
  } catch {
    return false;
  }
}

/** Whether bytes are a compiled file, by how they begin. */
export const isCompiled = (bytes: Uint8Array): boolean => SHORTEST.every((byte, place) => bytes[place] === byte);
