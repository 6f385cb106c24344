import type { Firmware } from '#hex/firmware';
import type { HexFile, MadeHex } from '#hex/hex';

import { askWorker } from '../../../session/run/worker/ask-worker';
import type { RunParts } from '../../../session/run/parts';
import type { HexAnswer, HexRequest } from '../../../session/run/worker/hex';

/** Writes a hex: `makeHex`, in another thread. */
export type HexWriter = (firmwares: readonly Firmware[], files: readonly HexFile[]) => Promise<MadeHex>;

/** Writes in a worker of its own. Rejects where none can be loaded. */
export const hexWriter =
  ({ run }: Pick<RunParts, 'run'>): HexWriter =>
  async (firmwares, files) => {
    const request: HexRequest = { type: 'make-hex', firmwares, files };
    return (await askWorker<HexAnswer>(() => run.engine.createWorker(), request)).made;
  };
