import { describe, expect, it } from 'vitest';
import { defaultScene, type Scene, type SceneObject } from '#scene/scene';
import { lightPalette } from '../../pupil/arena/model/palette';
import { courseSvg, type PictureOptions } from './svg-course';
import { element, escapeXml } from '#picture/svg-write';

const plain: PictureOptions = {
  grid: false,
  rulers: false,
  robot: null,
  path: [],
  background: null,
  floor: true,
  task: null,
};
const course = (objects: readonly SceneObject[], part: Partial<Scene> = {}): Scene => ({
  ...defaultScene(),
  objects,
  ...part,
});
const box = { at: [300, 200], size: [100, 60], angle: 45 } as const;
const everything: readonly SceneObject[] = [
  { type: 'stroke', id: 'a', points: [[100, 100], [400, 100]], width: 20, color: 'black' }, // prettier-ignore
  { type: 'stroke', id: 'b', points: [[5, 5]], width: 20, color: 'yellow' },
  { type: 'wall', id: 'c', from: [0, 0], to: [300, 400], thickness: 10 },
  { type: 'block', id: 'd', ...box },
  { type: 'fixed-block', id: 'e', ...box },
  { type: 'spikes', id: 'f', ...box },
  { type: 'mover', id: 'g', ...box, to: [500, 200], speed: 100, spiked: true },
  { type: 'target', id: 'h', ...box, round: false, number: 0, blocks: 0 },
  { type: 'target', id: 'i', ...box, round: true, number: 0, blocks: 2 },
  { type: 'checkpoint', id: 'j', ...box, round: false, number: 12, blocks: 0 },
  { type: 'forbidden', id: 'k', ...box, round: false, number: 0, blocks: 0 },
  { type: 'label', id: 'l', at: [600, 700], text: 'A & <B> "Zürich"', height: 30, angle: 90 },
];

describe('a picture of a course for worksheets', () => {
  it('has its true size in mm, y turned over: a line 100 mm above the lower edge is 800 mm below the upper', () => {
    const { svg, size, corner } = courseSvg(course(everything.slice(0, 1)), plain);
    expect(corner[0]).toBeCloseTo(4.8);
    expect(size[0]).toBeCloseTo(1209.6);
    expect(svg).toContain('width="1209.6mm" height="909.6mm" viewBox="0 0 1209.6 909.6"');
    expect(svg).toContain('d="M100 800L400 800"');
    expect(svg).toContain('stroke-width="20"');
  });

  it('shows the number of a checkpoint over the line that runs through it', () => {
    const { svg } = courseSvg(course(everything), plain);
    expect(svg.indexOf('>12</text>')).toBeGreaterThan(svg.indexOf(`stroke="${lightPalette.strokes.black}"`));
    expect(svg.indexOf('stroke-dasharray="4 5"')).toBeLessThan(svg.indexOf(`stroke="${lightPalette.strokes.black}"`));
  });

  it('is well-formed with everything in it: each element that opens closes in its turn', () => {
    const { svg } = courseSvg(course(everything, { name: 'Über <alles> & mehr' }), {
      ...plain,
      grid: true,
      rulers: true,
    });
    const open: string[] = [];
    for (const [, isEnd, name = '', isAlone] of svg.matchAll(/<(\/?)([\w:]+)(?:\s+[\w:-]+="[^"<>]*")*\s*(\/?)>/g)) {
      if (isAlone === '/') continue;
      if (isEnd === '') open.push(name);
      else expect(open.pop()).toBe(name);
    }
    expect(open).toEqual([]);
    // Nothing is left over that is neither an element nor text.
    expect(svg.replace(/<\?xml[^>]*\?>|<(\/?)([\w:]+)(?:\s+[\w:-]+="[^"<>]*")*\s*(\/?)>/g, '')).not.toMatch(/[<>]/);
    expect(svg).not.toMatch(/NaN|undefined|Infinity/);
  });

  it('writes texts so that nothing in them is taken for markup', () => {
    const { svg } = courseSvg(course(everything), plain);
    expect(svg).toContain('>A &#38; &#60;B&#62; &#34;Zürich&#34;</text>');
    expect(escapeXml('a\u0000b')).toBe('ab');
    expect(element('a', { b: '"', c: undefined })).toBe('<a b="&#34;"/>');
  });

  it('contains no script, style sheet or link', () => {
    const { svg } = courseSvg(course(everything), { ...plain, grid: true, rulers: true });
    expect(svg).not.toMatch(/<script|<style|href=|\son\w+=/);
  });

  it('puts the robot where it starts, its front along its heading', () => {
    const drawing =
      '<svg xmlns="http://www.w3.org/2000/svg" viewBox="-50 -60 100 120" width="100mm"><path d="M0 0"/></svg>';
    const robot = { pose: { xMm: 600, yMm: 450, headingRad: 0 }, scale: 1.5, drawing };
    const { svg } = courseSvg(course([]), { ...plain, robot });
    expect(svg).toContain('translate(600 450) rotate(90) scale(1.5)');
    expect(svg).toContain('<svg x="-50" y="-60" width="100" height="120" xmlns=');
  });

  it('shows the path of the robot in pieces, and the background where it lies', () => {
    const background = { at: [100, 200], size: [300, 400], cells: [1, 1], levels: '', picture: '' } as const;
    const { svg } = courseSvg(course([], { background }), {
      ...plain,
      path: [[{ x: 0, y: 0 }, { x: 10.5, y: 0 }], [{ x: 5, y: 5 }]], // prettier-ignore
      background: 'data:image/png;base64,AAAA',
    });
    expect(svg).toContain('d="M0 900L10.5 900"');
    expect(svg).toContain('<image x="100" y="300" width="300" height="400"');
  });
});
