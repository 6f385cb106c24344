import { describe, expect, it } from 'vitest';
import { exactAtan2, exactCos, exactSin } from '#core/exact-math';
import { eventfulRun, hashOf } from '../testing/rig';
import { Rot } from './planck';

describe('the physics engine', () => {
  it('computes with the exact sine, cosine and arc tangent', () => {
    for (let angle = -100; angle < 100; angle += 0.37) {
      const rotation = new Rot(angle);
      expect(rotation.s).toBe(exactSin(angle));
      expect(rotation.c).toBe(exactCos(angle));
      expect(rotation.getAngle()).toBe(exactAtan2(rotation.s, rotation.c));
    }
    expect(new Rot(1e9).s).toBeNaN(); // the engine's own sine has a value there
  });

  it('leaves the global Math as it was', () => {
    expect(Math.sin).not.toBe(exactSin);
    expect(Math.sin(1e9)).not.toBeNaN();
    expect(Math.cos(1e9)).not.toBeNaN();
    expect(Math.atan2.name).toBe('atan2');
  });

  it('drives the same way to the last bit on every machine', () => {
    expect(hashOf(eventfulRun())).toBe('795b3cd0');
  });

  it('gives two equal runs in one process', () => {
    expect(eventfulRun()).toEqual(eventfulRun());
  });
});
