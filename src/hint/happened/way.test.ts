import { describe, expect, it } from 'vitest';
import { sceneWith, targetAt } from '#check/testing/tasks';
import type { Moment } from '../watch/observed';
import { passedBy } from './way';

/** A robot's way: ahead by so many mm, or turned to the left by so many degrees. */
function wayOf(...parts: readonly (readonly ['ahead' | 'turn', number])[]): readonly Moment[] {
  let [xMm, yMm, headingRad] = [0, 0, 0];
  const moments: Moment[] = [];
  const add = (left: number, right: number): void =>
    void moments.push({
      ...{ timeUs: moments.length * 20_000, pose: { xMm, yMm, headingRad }, bright: [], touches: 0 },
      duty: { left, right },
    });
  for (const [what, value] of parts)
    for (let step = 0; step < 20; step += 1) {
      if (what === 'turn') headingRad += (value * Math.PI) / 180 / 20;
      xMm += what === 'ahead' ? (Math.cos(headingRad) * value) / 20 : 0;
      yMm += what === 'ahead' ? (Math.sin(headingRad) * value) / 20 : 0;
      add(what === 'turn' ? -1 : 1, 1);
    }
  add(0, 0);
  return moments;
}

describe('a robot that passed by a place', () => {
  const zone = targetAt(500, 330);
  const course = sceneWith([zone]);
  const seen = (moments: readonly Moment[]) => ({ moments, next: [zone], nextSinceUs: 0 });

  it('passed it after the turn before it, whatever it did afterwards', () => {
    const before = wayOf(['ahead', 200], ['turn', 90], ['ahead', 150], ['turn', -90], ['ahead', 700]);
    expect(passedBy(seen(before), course)).toMatchObject({ side: 'right', turns: 2 });
    const after = wayOf(['ahead', 200], ['turn', 90], ['ahead', 150], ['turn', -90], ['ahead', 700], ['turn', 90], ['ahead', 80]); // prettier-ignore
    expect(passedBy(seen(after), course)).toMatchObject({ side: 'right', turns: 2 });
  });

  it('did so only once the place was next', () => {
    const moments = wayOf(['ahead', 900], ['turn', 90], ['ahead', 600]);
    expect(passedBy({ ...seen(moments), nextSinceUs: 0 }, course)).not.toBeNull();
    expect(passedBy({ ...seen(moments), nextSinceUs: 700_000 }, course)).toBeNull();
  });
});
