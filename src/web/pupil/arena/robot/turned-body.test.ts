// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { TurnedBody, type BodyLook } from './turned-body';

const fake = () => ({
  save: vi.fn(),
  restore: vi.fn(),
  translate: vi.fn(),
  setTransform: vi.fn(),
  getTransform: () => ({ a: 2, b: 0, c: 0, d: 2, e: 0.3, f: 0 }),
  drawImage: vi.fn(),
});
type Fake = ReturnType<typeof fake>;
const asContext = (context: Fake): CanvasRenderingContext2D => context as unknown as CanvasRenderingContext2D;
const sprite = {};
const look = (changes: Partial<BodyLook> = {}): BodyLook => ({
  headingRad: 1,
  size: 0.5,
  ratio: 2,
  of: [sprite, false],
  ...changes,
});

describe('a robot that keeps its heading', () => {
  let screen: Fake;
  let aside: Fake;
  let body: TurnedBody;
  const paint = vi.fn();
  const draw = (changes?: Partial<BodyLook>): void => {
    body.draw(asContext(screen), { x: 100, y: 50 }, 20, look(changes), paint);
  };

  beforeEach(() => {
    [screen, aside, body] = [fake(), fake(), new TurnedBody()];
    vi.spyOn(HTMLCanvasElement.prototype, 'getContext').mockReturnValue(asContext(aside));
    paint.mockClear();
  });

  it('is turned once, and then put down as a picture on whole pixels', () => {
    draw();
    expect(paint.mock.calls).toEqual([[screen]]);
    draw();
    draw({ headingRad: 1.0005 });
    expect(paint.mock.calls).toEqual([[screen], [aside]]);
    expect(screen.drawImage.mock.calls.map(([, ...place]) => place as unknown)).toEqual([
      [160, 60],
      [160, 60],
    ]);
  });

  it('is kept some frames later where others may have come to rest in the same frame', () => {
    body = new TurnedBody(2);
    for (let frame = 0; frame < 4; frame++) draw();
    expect(paint.mock.calls).toEqual([[screen], [screen], [screen], [aside]]);
  });

  it.each([
    ['it turns', { headingRad: 1.01 }],
    ['the zoom changes', { size: 0.6 }],
    ['the screen changes', { ratio: 1 }],
    ['it looks otherwise', { of: [sprite, true] }],
    ['its lights go on', { of: [sprite, false, 255, 0, 0] }],
  ])('is painted anew when %s', (_, changes) => {
    draw();
    draw();
    draw(changes);
    expect(paint.mock.calls).toEqual([[screen], [aside], [screen]]);
  });
});
