import { describe, expect, it } from 'vitest';

import { RowWriter } from '#tape/rows/row-writer';
import { Recording } from './recording';
import { RecordedRows } from './recorded-rows';

/** A recording whose tape arrives in pieces, each with one of these moments. */
function recordingOf(...timesUs: readonly number[]): Recording {
  const recording = new Recording(null);
  const writer = new RowWriter();
  for (const timeUs of timesUs) {
    writer.add({ timeUs });
    const piece = writer.finish();
    if (piece !== null) recording.hear({ type: 'tape', piece, thinSinceUs: null });
  }
  return recording;
}

describe('the moments of the recording that was asked for last', () => {
  it('are unpacked once, as they come', () => {
    let unpacked = 0;
    const recorded = new RecordedRows({ chunk: () => (unpacked += 1) });
    const all = recordingOf(20_000, 40_000, 60_000);
    const now = new Recording(null);
    for (const piece of all.pieces) {
      now.hear({ type: 'tape', piece, thinSinceUs: null });
      recorded.of(now);
      recorded.of(now);
    }
    expect(unpacked).toBe(3);
    expect(recorded.of(now).at(50_000)?.timeUs).toBe(40_000);
  });

  it('begin anew with another recording, and nothing is left of the one before', () => {
    const begun: Recording[] = [];
    const recorded = new RecordedRows({ begin: (recording) => begun.push(recording) });
    const [long, short] = [recordingOf(20_000, 40_000), recordingOf(20_000)];
    expect([recorded.of(long).endUs, recorded.of(short).endUs]).toEqual([40_000, 20_000]);
    expect(begun).toEqual([long, short]);
  });
});
