// @vitest-environment happy-dom
import { describe, expect, it, vi } from 'vitest';
import { defaultScene } from '#scene/scene';
import type { ArenaRobot } from '../model/arena-model';
import { lightPalette } from '../model/palette';
import { robotAtStart } from '../picture/arranged';
import { drawRobot } from './draw-robot';
import type { RobotPainting } from './robot-painting';

const robot = robotAtStart(defaultScene(), { attachments: [], bumper: null });
const dark = Array.from({ length: 25 }, () => 0);

/** The values that the cached picture of a robot's body depends on. */
function keptBy(state: Partial<ArenaRobot['state']>, display = dark): unknown {
  const viewBox = { x: -40, y: -50, width: 80, height: 100 };
  const draw = vi.fn();
  const painting = {
    look: { body: { outlineMm: [] } },
    drawing: { viewBox, rgb: [] },
    sprites: { at: () => null },
    turned: { draw },
  } as unknown as RobotPainting;
  const context = new Proxy({}, { get: () => () => undefined, set: () => true }) as CanvasRenderingContext2D;
  const view = { pxPerMm: 1, originPx: { x: 0, y: 0 } } as never;
  const now = { ...robot, state: { ...robot.state, ...state } };
  drawRobot(context, view, 1, now, painting, { display, scale: 1, held: false }, lightPalette);
  return (draw.mock.calls[0]?.[3] as { readonly of: unknown }).of;
}

describe("the kept picture of a robot's body", () => {
  it('serves again while nothing shines otherwise', () => expect(keptBy({})).toEqual(keptBy({})));

  it.each([
    ['a line sensor sees white', { lineSensors: [{ name: 'left', bright: true }] }, dark],
    ['the left light goes on', { leds: { left: 1, right: 0 } }, dark],
    ['the right light goes on', { leds: { left: 0, right: 1 } }, dark],
    ['a light on the floor goes on', { rgb: [[255, 0, 0]] }, dark],
    ['the display shows something', {}, dark.with(12, 9)],
  ] as const)('is another one when %s', (_, state, display) =>
    expect(keptBy(state as unknown as Partial<ArenaRobot['state']>, [...display])).not.toEqual(keptBy({})),
  );
});
