import type { Recording } from '../../../session/run/recording';
import { emptyTape, unpackTape, type RunTape } from '../../../session/run/unpack-tape';

/** Unpacks the pieces of a recording. @returns `null`: nobody wanted it any more, or there is nothing */
export async function runTape(recording: Recording, isWanted: () => boolean): Promise<RunTape | null> {
  const tape = emptyTape();
  const devices = (): number => recording.setup?.devices.length ?? 1;
  const isWhole = await unpackTape(recording.pieces, { into: tape, devices, isWanted });
  return isWhole && tape.rows.endUs > 0 ? tape : null;
}
