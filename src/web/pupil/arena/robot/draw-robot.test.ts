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
    [
      'a colour lamp goes on',
      {
        lamps: [
          [0, 255, 255],
          [0, 0, 0],
        ],
      },
      dark,
    ],
    ['the display shows something', {}, dark.with(12, 9)],
  ] as const)('is another one when %s', (_, state, display) =>
    expect(keptBy(state as unknown as Partial<ArenaRobot['state']>, [...display])).not.toEqual(keptBy({})),
  );
});

describe('the colour lights of a robot', () => {
  /** The order in which its body and two of its lights are drawn: one on top at x = 1, one below at x = 2. */
  function drawn(rgb: readonly (readonly [number, number, number])[]): readonly string[] {
    const steps: string[] = [];
    const [body, shadow] = [document.createElement('canvas'), document.createElement('canvas')];
    const acts: Record<string, unknown> = {
      drawImage: (image: unknown) => image === body && steps.push('body'),
      arc: (x: number, _y: number, radius: number) => steps.push(`light at ${x}, ${radius} mm`),
      createRadialGradient: () => ({ addColorStop: () => undefined }),
    };
    const context = new Proxy(acts, { get: (own, name) => own[String(name)] ?? (() => undefined), set: () => true });
    const viewBox = { x: -40, y: -50, width: 80, height: 100 };
    const lights = [
      { x: 1, y: 0, radius: 2, isOnTop: true },
      { x: 2, y: 0, radius: 4, isOnTop: false },
    ];
    const painting = {
      look: { body: { outlineMm: [] } },
      drawing: {
        viewBox,
        rgb: lights,
        wheels: { left: null, right: null },
        line: new Map(),
        display: [],
        leds: { left: null, right: null },
        lamps: { left: null, right: null },
      },
      sprites: { at: () => ({ body, shadow, shadowBox: viewBox }) },
      turned: { draw: (...[around, , , , still]: readonly ((around: unknown) => void)[]) => still?.(around) },
    } as unknown as RobotPainting;
    const lit = { ...robot, state: { ...robot.state, rgb } };
    const view = { pxPerMm: 1, originPx: { x: 0, y: 0 } } as never;
    const look = { display: dark, scale: 1, held: false };
    drawRobot(context as unknown as CanvasRenderingContext2D, view, 1, lit, painting, look, lightPalette);
    return steps;
  }

  it('are drawn below the body where they are under it, else above it: a glow and the light itself', () => {
    const red = [255, 0, 0] as const;
    expect(drawn([red, red])).toEqual(['light at 2, 7 mm', 'body', 'light at 1, 6 mm', 'light at 1, 2 mm']);
  });

  it('are not drawn while they are dark', () => {
    const off = [0, 0, 0] as const;
    expect(drawn([off, off])).toEqual(['body']);
  });
});
