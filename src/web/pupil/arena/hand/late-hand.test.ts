import { describe, expect, it } from 'vitest';
import type { Vec } from '#core/geometry';
import type * as Parts from './hand-parts';
import { createLateHand } from './late-hand';

const outlineMm = [[{ x: 50, y: -40 }, { x: 50, y: 40 }, { x: -30, y: 40 }, { x: -30, y: -40 }]]; // prettier-ignore
const VIEW = { pxPerMm: 1, leftPx: 0, bottomPx: 800 };
const ROBOT = { pose: { xMm: 500, yMm: 400, headingRad: 0 }, outlineMm, scale: 1 };
/** A point of the arena of 1000 × 800 mm, in px: there is 1 px per mm. */
const px = (x: number, y: number): Vec => ({ x, y: 800 - y });
const press = (at: Vec) => ({ id: 1, at, touch: false, pansOnly: false });

/** A hand over a robot in the middle of the arena, which comes when it is brought. */
function handThatComes() {
  const placed: string[] = [];
  const pans: Vec[] = [];
  const asked: { bring(): Promise<void>; fail(): Promise<void> }[] = [];
  const load = () =>
    new Promise<typeof Parts>((there, failed) => {
      const settled = () => new Promise<void>((done) => setTimeout(done));
      asked.push({
        bring: async () => (there(await import('./hand-parts')), settled()),
        fail: () => (failed(new Error('offline')), settled()),
      });
    });
  const hand = createLateHand(
    {
      view: () => VIEW,
      arena: () => [1000, 800],
      robot: () => ROBOT,
      blocks: () => [],
      place: (_, { xMm, yMm, headingDeg }) => placed.push(`${String(xMm)} ${String(yMm)} ${String(headingDeg)}°`),
      pan: (by) => pans.push(by),
      zoom: () => undefined,
      changed: () => undefined,
      nowMs: () => 0,
    },
    load,
  );
  return { hand, placed, pans, asked };
}

describe('a hand that is not loaded yet', () => {
  it('holds nothing, shows no ring, and is not loaded before somebody touches the arena', () => {
    const { hand, asked } = handThatComes();
    hand.pointerUp(1);
    hand.pointerLeave();
    hand.focus(false);
    hand.keyUp();
    expect([hand.held, hand.cursor, hand.marks(VIEW, ROBOT, null), asked.length]).toEqual([null, 'default', null, 0]);
    expect(hand.poseOf({ kind: 'robot' }, ROBOT.pose)).toBe(ROBOT.pose);
  });

  it('puts the robot down where the first drag has ended before it came', async () => {
    const { hand, placed, asked } = handThatComes();
    hand.pointerDown(press(px(500, 400)));
    hand.pointerMove(1, px(600, 400));
    hand.pointerMove(1, px(700, 400));
    hand.pointerUp(1);
    expect([placed, asked.length]).toEqual([[], 1]);
    await asked[0]?.bring();
    expect([placed, hand.held]).toEqual([['700 400 0°'], null]);
  });

  it('holds the robot in the middle of a drag', async () => {
    const { hand, asked } = handThatComes();
    hand.pointerDown(press(px(500, 400)));
    await asked[0]?.bring();
    expect(hand.held).toEqual({ thing: { kind: 'robot' }, turning: false });
    expect(hand.cursor).toBe('grabbing');
    expect(hand.marks(VIEW, ROBOT, ROBOT.pose)?.boxes).toHaveLength(2);
  });

  it('moves the picture by all of the first drag', async () => {
    const { hand, pans, asked } = handThatComes();
    hand.pointerDown(press(px(100, 100)));
    hand.pointerMove(1, px(130, 100));
    await asked[0]?.bring();
    expect(pans).toEqual([{ x: 30, y: 0 }]);
  });

  it('moves the robot by the first arrow key, and leaves other keys to the page', async () => {
    const { hand, placed, asked } = handThatComes();
    expect([hand.keyDown('Tab', false), hand.keyDown('Escape', false), asked.length]).toEqual([false, false, 0]);
    expect(hand.keyDown('ArrowRight', true)).toBe(true);
    hand.keyUp();
    await asked[0]?.bring();
    expect(new Set(placed)).toEqual(new Set(['501 400 0°']));
  });

  it('forgets a drag when a tool takes over', async () => {
    const { hand, placed, asked } = handThatComes();
    hand.pointerDown(press(px(500, 400)));
    hand.pointerMove(1, px(700, 400));
    hand.release();
    await asked[0]?.bring();
    expect([placed, hand.held]).toEqual([[], null]);
  });

  it('comes with the next touch when the network was gone', async () => {
    const { hand, asked } = handThatComes();
    hand.pointerMove(1, px(500, 400));
    await asked[0]?.fail();
    hand.pointerMove(1, px(500, 400));
    await asked[1]?.bring();
    expect([asked.length, hand.cursor]).toEqual([2, 'grab']);
  });
});
