import { describe, expect, it } from 'vitest';
import { createFrameGate } from './frame-gate';

function gateWithFrames() {
  const frames: (() => void)[] = [];
  let done = 0;
  const gate = createFrameGate(
    () => (done += 1),
    (callback) => void frames.push(callback),
  );
  return { gate, done: () => done, nextFrame: () => frames.shift()?.() };
}

describe('a frame gate', () => {
  it('acts at once, and once more in the next frame for 3 further calls', () => {
    const { gate, done, nextFrame } = gateWithFrames();
    for (let i = 0; i < 4; i += 1) gate.soon();
    expect(done()).toBe(1);
    nextFrame();
    expect(done()).toBe(2);
    nextFrame();
    expect(done()).toBe(2);
  });

  it('acts at once again after a frame without a call', () => {
    const { gate, done, nextFrame } = gateWithFrames();
    gate.soon();
    nextFrame();
    gate.soon();
    expect(done()).toBe(2);
  });

  it('does nothing more after it is closed', () => {
    const { gate, done, nextFrame } = gateWithFrames();
    gate.soon();
    gate.soon();
    gate.close();
    nextFrame();
    expect(done()).toBe(1);
  });
});
