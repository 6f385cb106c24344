import { describe, expect, it } from 'vitest';
import { pictureOf } from '../../../app/testing/run';
import type { FromWorker } from './protocol';
import { packPictures, unpackPictures } from './pictures';

const snapshot = (timeUs: number): FromWorker => ({
  type: 'snapshot',
  snapshot: pictureOf({ timeUs }),
  trails: [[1, 2]],
});

describe('pictures on their way to the page', () => {
  it('come out as the snapshots that they were, each an object of its own', () => {
    const [pack, unpack] = [packPictures(), unpackPictures()];
    const sent = [snapshot(20_000), snapshot(20_000), snapshot(40_000)];
    const heard = sent.map((message) => unpack(structuredClone(pack(message))));
    expect(heard).toEqual(sent);
    const [first, again] = heard.map((message) => (message.type === 'snapshot' ? message.snapshot : null));
    expect(first).not.toBe(again);
    expect(first?.sensors).toBe(again?.sensors);
  });

  it('hold the time alone where nothing else has changed, and leave other messages as they are', () => {
    const pack = packPictures();
    pack(snapshot(20_000));
    expect(pack(snapshot(40_000))).toEqual({ type: 'picture', changes: { timeUs: [40_000] }, trails: [[1, 2]] });
    expect(pack({ type: 'stopped' })).toEqual({ type: 'stopped' });
  });
});
