/** Writing a hex, in a worker of its own: the libraries that do it take a second or two. */
import type { Firmware } from '#hex/firmware';
import type { HexFile, MadeHex } from '#hex/hex';
import { makeHex } from '#hex/make';

/** From the page: these files are wanted beside these firmwares; see `makeHex`. */
export interface HexRequest {
  readonly type: 'make-hex';
  readonly firmwares: readonly Firmware[];
  readonly files: readonly HexFile[];
}

/** To the page. */
export type HexAnswer =
  { readonly type: 'hex-made'; readonly made: MadeHex } | { readonly type: 'failed'; readonly message: string };

/** Answers a request; never throws. */
export function answerHex({ firmwares, files }: HexRequest): HexAnswer {
  try {
    return { type: 'hex-made', made: makeHex(firmwares, files) };
  } catch (error) {
    return { type: 'failed', message: error instanceof Error ? error.message : String(error) };
  }
}
