// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';
import type { DeviceRing } from './draw-ring';
import { deviceAt, FINGER_PX } from './use-press-places';

const ring = (place: number, x: number): DeviceRing => ({
  middle: { x, y: 200 },
  radiusPx: 40,
  place,
  color: place,
  name: '', // its pill is as wide as high: 24 px, 6 px above the ring
  isShown: place === 0,
});
const rings = [ring(0, 100), ring(1, 300), ring(2, 310)];
const anyBody = (): boolean => true;
const noBody = (): boolean => false;
const nameTop = 200 - 40 - 6 - 24;

describe('a press on the arena', () => {
  it('is for the device whose name was pressed', () => {
    expect(deviceAt(rings, { x: 100, y: nameTop + 12 }, noBody)).toBe(0);
    expect(deviceAt(rings, { x: 100, y: nameTop - FINGER_PX }, noBody)).toBe(0);
    expect(deviceAt(rings, { x: 100, y: nameTop - FINGER_PX - 1 }, noBody)).toBeNull();
    expect(deviceAt(rings, { x: 130, y: nameTop + 12 }, noBody)).toBeNull();
  });

  it('counts on the robot itself only while that counts', () => {
    expect(deviceAt(rings, { x: 100, y: 200 }, anyBody)).toBe(0);
    expect(deviceAt(rings, { x: 100, y: 200 }, noBody)).toBeNull();
    expect(deviceAt(rings, { x: 100, y: 200 }, ({ isShown }) => !isShown)).toBeNull();
  });

  it('is for the name that is painted above where two overlap', () => {
    expect(deviceAt(rings, { x: 305, y: nameTop + 12 }, noBody)).toBe(2);
  });
});
