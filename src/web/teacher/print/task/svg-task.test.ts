import { describe, expect, it } from 'vitest';

import { taskSvg } from './svg-task';

const task = { title: 'Um & durch', text: 'Fahre **los**.\n\n- `forward()`\n\n' + 'Wort '.repeat(80) };

describe('the task in a picture', () => {
  it('stands below an arena and makes the picture higher, not wider', () => {
    const { svg, size } = taskSvg(task, [1200, 900], [5, 5], [1210, 910]);
    expect(size[0]).toBe(1210);
    expect(size[1]).toBeGreaterThan(1050);
    for (const [, x, y] of svg.matchAll(/<text x="([\d.]+)" y="([\d.]+)"/g)) {
      expect(Number(x)).toBeGreaterThanOrEqual(5);
      expect(Number(y)).toBeGreaterThan(910);
      expect(Number(y)).toBeLessThan(size[1]);
    }
  });

  it('stands beside a high arena', () => {
    const { svg, size } = taskSvg(task, [500, 1000], [5, 5], [510, 1010]);
    expect(size[0]).toBeGreaterThan(1010);
    expect(size[1]).toBe(1010);
    for (const [, x] of svg.matchAll(/<text x="([\d.]+)"/g)) expect(Number(x)).toBeGreaterThan(510);
  });

  it('makes a picture higher where the text beside is longer than the arena', () => {
    const long = { title: '', text: 'Wort '.repeat(3000) };
    expect(taskSvg(long, [500, 1000], [5, 5], [510, 1010]).size[1]).toBeGreaterThan(1010);
  });

  it('keeps bold, code and lists, and takes no text for XML', () => {
    const { svg } = taskSvg(task, [1200, 900], [5, 5], [1210, 910]);
    expect(svg).toContain('Um &#38; durch');
    expect(svg).toMatch(/Fahre <tspan font-weight="700">los<\/tspan>\./);
    expect(svg).toMatch(/<tspan font-family="[^"]*mono[^>]*>forward\(\)<\/tspan>/i);
    expect(svg).toContain('>•</text>');
  });
});
