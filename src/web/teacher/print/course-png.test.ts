// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { packLevels } from '#scene/background';
import { defaultScene, type Background, type Scene } from '#scene/scene';

import { lightPalette } from '../../pupil/arena/model/palette';
import { backgroundForPdf, coursePng, pictureAddress, sizedForPdf } from './picture-parts';
import type { PictureOptions } from './svg-course';

const plain: PictureOptions = {
  grid: false,
  rulers: false,
  robot: null,
  path: [],
  background: null,
  floor: true,
  task: null,
};
const PHOTO = 'data:image/webp;base64,AAAA';

/** A canvas that notes what is painted on it, with its colour and how it is mixed with what is there. */
function canvases() {
  const painted: (readonly unknown[])[] = [];
  const pixels: number[][] = [];
  const used: HTMLCanvasElement[] = [];
  const look = { fillStyle: '', globalCompositeOperation: 'source-over' };
  let saved = { ...look };
  const context = Object.assign(look, {
    save: () => (saved = { ...look }),
    restore: () => Object.assign(look, saved),
    scale: (x: number, y: number) => painted.push(['scale', x, y]),
    translate: (x: number, y: number) => painted.push(['translate', x, y]),
    beginPath: () => undefined,
    rect: (...at: number[]) => painted.push(['around', ...at]),
    clip: () => painted.push(['clip']),
    fillRect: (...at: number[]) => painted.push(['fill', look.fillStyle, ...at]),
    drawImage: (image: HTMLImageElement, ...at: number[]) =>
      painted.push(['picture', image.src.slice(0, 18), look.globalCompositeOperation, ...at]),
    putImageData: (image: ImageData) => pixels.push([...image.data]),
  });
  vi.spyOn(HTMLCanvasElement.prototype, 'getContext').mockImplementation(function (this: HTMLCanvasElement) {
    used.push(this);
    return context as never;
  });
  return { painted, pixels, size: () => [used.at(-1)?.width, used.at(-1)?.height] };
}

beforeEach(() => {
  vi.stubGlobal(
    'Image',
    class {
      src = '';
      readonly naturalWidth = 320;
      readonly naturalHeight = 200;
      decode = () => (this.src.includes('broken') ? Promise.reject(new Error('broken')) : Promise.resolve());
    },
  );
  vi.spyOn(HTMLCanvasElement.prototype, 'toDataURL').mockImplementation((type) => `data:${type ?? ''};base64,painted`);
  vi.spyOn(HTMLCanvasElement.prototype, 'toBlob').mockImplementation((give, type) =>
    give(new Blob(['painted'], { type: type ?? '' })),
  );
});
afterEach(() => {
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

/** 400 × 200 mm in an arena of 1200 × 900, with its lower left corner at x 100, y 300. */
const background: Background = {
  ...{ at: [100, 300], size: [400, 200], cells: [2, 2], picture: PHOTO },
  levels: packLevels(Uint8Array.of(0, 15, 5, 10)),
};
const scene = (more: Partial<Scene> = {}): Scene => ({ ...defaultScene(), size: [1200, 900], ...more });

describe('a course as a picture of points', () => {
  it('has as many on its longer side as was asked for, and its own shape', async () => {
    const { size } = canvases();
    await coursePng(scene(), plain, 1800);
    expect(size()[0]).toBe(1800);
    expect((size()[0] ?? 0) / (size()[1] ?? 1)).toBeCloseTo(4 / 3, 1);
    await coursePng(scene({ size: [500, 1000] }), plain, 4000);
    expect(size()[1]).toBe(4000);
  });

  it('is as sharp with the task below it, and 4000 points long at most', async () => {
    const { size } = canvases();
    const task = { title: 'Slalom', text: 'Fahre um die Tore.' };
    await coursePng(scene(), { ...plain, task }, 1800);
    expect(size()[0]).toBe(1800);
    expect(size()[1]).toBeGreaterThan(1400);
    await coursePng(scene(), { ...plain, task: { ...task, text: 'Wort '.repeat(4000) } }, 1800);
    expect(size()[0]).toBeLessThan(1800);
    expect(size()[1]).toBe(4000);
  });

  it('is painted on white: first the floor, then the drawing over all of it', async () => {
    const { painted, size } = canvases();
    const blob = await coursePng(scene(), plain, 1800);
    const [width, height] = size();
    expect(blob.type).toBe('image/png');
    expect(painted[0]).toEqual(['fill', '#ffffff', 0, 0, width, height]);
    expect(painted.find(([act, color]) => act === 'fill' && color === lightPalette.floor)).toEqual([
      ...['fill', lightPalette.floor, 0, 0, 1200, 900],
    ]);
    expect(painted.at(-1)).toEqual(['picture', 'data:image/svg+xml', 'source-over', 0, 0, width, height]);
  });

  it('has the floor’s picture where it lies, darkening the floor, and nothing of it beyond the arena', async () => {
    const { painted } = canvases();
    await coursePng(scene({ background }), { ...plain, background: PHOTO }, 1800);
    const at = painted.findIndex(([act, , mixed]) => act === 'picture' && mixed === 'multiply');
    // Its upper edge is at y 500 from below, so 400 from above.
    expect(painted[at]).toEqual(['picture', PHOTO.slice(0, 18), 'multiply', 100, 400, 400, 200]);
    expect(painted.slice(0, at)).toContainEqual(['around', 0, 0, 1200, 900]);
    expect(painted.slice(0, at)).toContainEqual(['clip']);
  });

  it('fails, instead of being empty, when the browser cannot make it', async () => {
    canvases();
    await expect(
      coursePng(scene({ background }), { ...plain, background: 'data:image/png;base64,broken' }, 1800),
    ).rejects.toThrow();
    vi.spyOn(HTMLCanvasElement.prototype, 'toBlob').mockImplementation((give) => give(null));
    await expect(coursePng(scene(), plain, 1800)).rejects.toThrow('no PNG');
    vi.spyOn(HTMLCanvasElement.prototype, 'getContext').mockReturnValue(null);
    await expect(coursePng(scene(), plain, 1800)).rejects.toThrow('no canvas');
  });
});

describe('what the eye sees of a background', () => {
  it('is its picture', () => expect(pictureAddress(background)).toBe(PHOTO));

  it('is its grid in greys from black to white where it has none', () => {
    const { pixels, size } = canvases();
    vi.stubGlobal(
      'ImageData',
      class {
        readonly data: Uint8ClampedArray;
        constructor(width: number, height: number) {
          this.data = new Uint8ClampedArray(4 * width * height);
        }
      },
    );
    expect(pictureAddress({ ...background, picture: '' })).toBe('data:image/png;base64,painted');
    expect(size()).toEqual([2, 2]);
    const grey = (level: number) => [level, level, level, 255];
    expect(pixels).toEqual([[...grey(0), ...grey(255), ...grey(85), ...grey(170)]]);
  });

  it('is nothing where the grid is damaged', () =>
    expect(pictureAddress({ ...background, picture: '', levels: 'AAAA' })).toBeNull());
});

describe('the picture of a task on paper', () => {
  it('comes with its size in pixels', async () => {
    const data = 'data:image/png;base64,AAAA';
    expect(await sizedForPdf(data)).toEqual({ data, format: 'PNG', size: [320, 200] });
  });

  it('is left out where it is damaged', async () =>
    expect(await sizedForPdf('data:image/png;base64,broken')).toBeNull());
});

describe('a background on paper', () => {
  it.each([
    ['data:image/png;base64,AAAA', 'PNG'],
    ['data:image/jpeg;base64,AAAA', 'JPEG'],
  ])('stays as it is where a PDF can hold it: %s', async (picture, format) => {
    const { painted } = canvases();
    expect(await backgroundForPdf({ ...background, picture })).toEqual({ data: picture, format });
    expect(painted).toEqual([]);
  });

  it('is painted anew on white where it cannot: WebP', async () => {
    const { painted, size } = canvases();
    expect(await backgroundForPdf(background)).toEqual({ data: 'data:image/jpeg;base64,painted', format: 'JPEG' });
    expect(size()).toEqual([320, 200]);
    expect(painted).toEqual([
      ['fill', '#ffffff', 0, 0, 320, 200],
      ['picture', PHOTO.slice(0, 18), 'source-over', 0, 0],
    ]);
  });

  it('is left out where there is none, or none that can be read', async () => {
    expect(await backgroundForPdf(null)).toBeNull();
    expect(await backgroundForPdf({ ...background, picture: '', levels: 'AAAA' })).toBeNull();
    vi.spyOn(HTMLCanvasElement.prototype, 'getContext').mockReturnValue(null);
    expect(await backgroundForPdf(background)).toBeNull();
  });
});
