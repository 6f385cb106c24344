import type { Snapshot } from '#simulation/snapshot';
import { Rows } from '#tape/rows/rows';
import type { Recording } from '../../run/recording';
import { Trails } from '../../run/trails';
import { unpackTape } from '../../run/unpack-tape';
import { addWays } from '../../run/ways-of-tape';

/** The moments of a run, and the ways of its robots. */
export interface RunTape {
  readonly rows: Rows<Snapshot>;
  readonly trails: Trails;
}

/** Unpacks what is there of a recording. @returns `null`: nobody wanted it any more, or there is nothing */
export async function runTape(recording: Recording, isWanted: () => boolean): Promise<RunTape | null> {
  const tape = { rows: new Rows<Snapshot>(), trails: new Trails() };
  const devices = recording.setup?.devices.length ?? 1;
  const isWhole = await unpackTape(recording.pieces, {
    rows: tape.rows,
    isWanted,
    onChunk: (chunk) => addWays(chunk, devices, tape.trails),
  });
  return isWhole && tape.rows.endUs > 0 ? tape : null;
}
