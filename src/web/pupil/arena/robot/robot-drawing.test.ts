import { describe, expect, it } from 'vitest';
import { fetchDrawing } from '#robots/drawings';
import { robotTypes } from '#robots/index';
import { readRobotDrawing, withPixelSize } from './robot-drawing';

const robots = await Promise.all(robotTypes.map(async (type) => ({ ...type, drawing: await fetchDrawing(type.id) })));

const svg = `<!-- a <g id="led-left"> in a comment -->
<svg xmlns="http://www.w3.org/2000/svg" viewBox="-50 -80 100 120" width="100mm" height="120mm">
  <g filter="url(#blur)"><circle id="rgb-0" cx="-33" cy="-46" r="18"/><circle id="rgb-1" cx="-27" cy="17" r="17" /></g>
  <g id="wheel-left">
    <rect x="-39.7" y="-21.5" width="9.4" height="43" rx="3.4" fill="#14171a"/>
    <g class="tread"><g><path d="M-38.9 -17.5l3.9 -1.6"/></g><path d="M0 0"/></g>
  </g>
  <circle id="line-left" cx="-7" cy="-35" r="3.6"/><circle id="line-right" cx="7" cy="-35" r="3.6"/>
  <g id="led-right"><circle class="glow" cx="27" cy="-50" r="9"/><circle cx="27" cy="-49" r="3.1"/><circle class="lit" cx="27" cy="-49" r="2.5"/></g>
  <g id="lamp-left"><circle class="glow" cx="-27" cy="-66" r="9"/><circle class="lit" cx="-27" cy="-65" r="2.6"/></g>
  <g id="display"><rect x="-9" y="-25" width="2" height="1.5"/><rect x="-5" y="-25" width="2" height="1.5"/></g>
  <circle id="screw" cx="1" cy="2" r="3"/>
</svg>`;

describe('a robot drawing', () => {
  const drawing = readRobotDrawing(svg);

  it('knows the tyre of 9.4 × 43 mm on the left and none on the right', () => {
    expect(drawing.wheels.left).toEqual({ x: -39.7, y: -21.5, width: 9.4, height: 43 });
    expect(drawing.wheels.right).toBeNull();
  });

  it('knows 2 lights under the body, 1 red light, 1 colour lamp, 2 line sensors by name and the lights of the display', () => {
    expect(drawing.rgb.map((light) => light.radius)).toEqual([18, 17]);
    expect(drawing.leds).toEqual({ left: null, right: { x: 27, y: -49, radius: 2.5 } });
    expect(drawing.lamps).toEqual({ left: { x: -27, y: -65, radius: 2.6 }, right: null });
    expect([...drawing.line].map(([name, light]) => [name, light.x])).toEqual([
      ['left', -7],
      ['right', 7],
    ]);
    expect(drawing.display.map((light) => light.x)).toEqual([-9, -5]);
  });

  it('knows which colour lights are on top of the body: those of class top', () => {
    const top =
      '<svg><circle id="rgb-0" cx="1" cy="1" r="2"/><circle id="rgb-1" class="top" cx="1" cy="9" r="2"/></svg>';
    expect(readRobotDrawing(top).rgb.map(({ isOnTop }) => isOnTop)).toEqual([false, true]);
  });

  it('leaves the colour lights and the still tread out of the picture, and nothing else', () => {
    expect(drawing.svg).not.toContain('rgb-');
    expect(drawing.svg).not.toContain('tread');
    expect(drawing.svg).toContain('rx="3.4" fill="#14171a"/>');
    expect(drawing.svg).toContain('id="screw"');
    expect(drawing.svg).toContain('class="lit"');
  });

  it('covers 160 × 160 mm when the file does not say what it covers', () => {
    expect(drawing.viewBox).toEqual({ x: -50, y: -80, width: 100, height: 120 });
    expect(readRobotDrawing('<svg></svg>').viewBox).toEqual({ x: -80, y: -80, width: 160, height: 160 });
  });

  it('gets a size of 200 × 240 px in place of its own', () => {
    const sized = withPixelSize(svg, 200, 240);
    expect(sized).toContain('<svg width="200" height="240"');
    expect(sized).not.toContain('100mm');
    expect(withPixelSize('<svg viewBox="0 0 1 1"/>', 1, 1)).toContain('xmlns="http://www.w3.org/2000/svg"');
  });
});

describe('the bumper of a drawing', () => {
  const text = `<svg viewBox="-50 -80 100 120">
  <defs><linearGradient id="metal"/></defs>
  <g id="bumper" stroke-linecap="round">
    <g id="bumper-left"><path d="M-1 0"/></g>
    <g id="bumper-right"><path d="M1 0"/></g>
  </g>
  <g id="body"><path d="M0 9"/></g>
</svg>`;
  const { bumper, svg: rest } = readRobotDrawing(text);

  it('is left out of the picture: most robots carry none at first', () => {
    expect(rest).not.toContain('bumper');
    expect(rest).toContain('M0 9');
  });

  it('comes as two documents, each with one half and what it needs', () => {
    for (const [half, own, other] of [
      [bumper?.left, 'M-1 0', 'M1 0'],
      [bumper?.right, 'M1 0', 'M-1 0'],
    ] as const) {
      expect(half).toContain(own);
      expect(half).not.toContain(other);
      expect(half).not.toContain('M0 9');
      expect(half).toContain('<linearGradient id="metal"/>');
      expect(half).toContain('stroke-linecap="round"');
      expect(readRobotDrawing(half ?? '').viewBox.width).toBe(100);
      expect(half?.match(/<g\b/g)?.length).toBe(half?.match(/<\/g>/g)?.length);
    }
  });

  it('is none in a drawing without one', () => {
    expect(readRobotDrawing(svg).bumper).toBeNull();
  });
});

describe.each(robots)('the drawing of $name', ({ drawing: text, body }) => {
  const drawing = readRobotDrawing(text);
  const { x, y, width, height } = drawing.viewBox;

  it('shows all of its body', () => {
    for (const corner of body.outlineMm.flat()) {
      expect(-corner.y).toBeGreaterThanOrEqual(x);
      expect(-corner.y).toBeLessThanOrEqual(x + width);
      expect(-corner.x).toBeGreaterThanOrEqual(y);
      expect(-corner.x).toBeLessThanOrEqual(y + height);
    }
  });

  it('marks its wheels on their sides, and its lights where there are any', () => {
    expect(drawing.wheels.left?.x ?? -1).toBeLessThan(0);
    expect(drawing.wheels.right?.x ?? 1).toBeGreaterThan(0);
    expect(drawing.leds.left?.x ?? -1).toBeLessThan(0);
    expect(drawing.leds.right?.x ?? 1).toBeGreaterThan(0);
    expect([0, 25]).toContain(drawing.display.length);
  });

  it('weighs less than 20 kB', () => {
    expect(text.length).toBeLessThan(20_000);
  });
});

describe.each(robots.filter(({ place }) => place <= 3))('the drawing of $name, which is ours', (type) => {
  it('marks both wheels, both red lights or colour lamps, and the 25 lights of the display', () => {
    const { wheels, leds, lamps, display } = readRobotDrawing(type.drawing);
    const lights = [leds.left ?? lamps.left, leds.right ?? lamps.right];
    expect([wheels.left, wheels.right, ...lights]).not.toContain(null);
    expect(display).toHaveLength(25);
  });
});
