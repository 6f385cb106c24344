import { describe, expect, it } from 'vitest';
import { defaultScene, type Scene, type SceneObject } from '#scene/scene';
import { coursePdf, type PrintWords } from './pdf-course';
import { printable, runsWithin } from './shapes/pdf-shapes';
import { planPrint, type Paper } from './print-plan';
import type { PaperTask } from './task/task-blocks';

const words: PrintWords = { name: 'Üben & mehr', planTitle: 'Plan', steps: ['Print', 'Glue'] };
const course = (objects: readonly SceneObject[], size: readonly [number, number] = [1200, 900]): Scene => ({
  ...defaultScene(),
  size,
  objects,
});

/** The pages of a print: each with its size and its drawing operators, as they stand in the PDF. */
function pagesOf(
  scene: Scene,
  paper: Paper,
  task: PaperTask | null = null,
): { readonly sizeMm: readonly number[]; readonly operators: string }[] {
  const plan = planPrint(scene.size, paper);
  if ('problem' in plan) throw new Error(plan.problem);
  const options = { outlines: true, background: null, isCompressed: false };
  const text = coursePdf(scene, plan, options, words, task).output();
  const sizes = [...text.matchAll(/\/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]/g)];
  const streams = [...text.matchAll(/stream\n([\s\S]*?)\nendstream/g)];
  return sizes.map(([, width, height], i) => ({
    sizeMm: [mm(width), mm(height)],
    operators: streams[i]?.[1] ?? '',
  }));
}
const mm = (points: string | undefined): number => (Number(points) * 25.4) / 72;

/** The straight lines of a page in mm from its upper left corner, with their width: `[x1, y1, x2, y2, width]`. */
function linesOf({ operators, sizeMm }: ReturnType<typeof pagesOf>[number]): number[][] {
  const lines: number[][] = [];
  let width = 0;
  let at: readonly number[] = [];
  for (const line of operators.split('\n')) {
    const [a, b, c] = line.split(' ');
    if (b === 'w') width = mm(a);
    const place = [mm(a), (sizeMm[1] ?? 0) - mm(b)];
    if (c === 'l') lines.push([...at, ...place, width]);
    if (c === 'm' || c === 'l') at = place;
  }
  return lines;
}
const stroke: SceneObject = {
  type: 'stroke',
  id: 's',
  points: [[100, 850], [250, 850]], // prettier-ignore
  width: 20,
  color: 'black',
};
const nearTo = (line: readonly number[]) => (other: readonly number[]) =>
  line.every((value, i) => Math.abs(value - (other[i] ?? NaN)) < 0.1);

describe('a course printed true to scale', () => {
  it('has pages of A4 across, one more for the plan', () => {
    const pages = pagesOf(course([stroke]), 'a4-tiles');
    expect(pages).toHaveLength(26);
    for (const { sizeMm } of pages) {
      expect(sizeMm[0]).toBeCloseTo(297, 3);
      expect(sizeMm[1]).toBeCloseTo(210, 3);
    }
  });

  it('shows a line of 150 mm at its place and 20 mm wide on each sheet that shows it, to 0.1 mm', () => {
    const [, a1, b1, c1] = pagesOf(course([stroke]), 'a4-tiles');
    if (a1 === undefined || b1 === undefined || c1 === undefined) throw new Error('too few pages');
    // 50 mm below the upper edge of the arena, and 10 mm of margin.
    expect(linesOf(a1).filter(nearTo([110, 60, 260, 60, 20]))).toHaveLength(1);
    // The second sheet begins 267 mm further right: the line's round end reaches 260 mm, so it shows nothing of it.
    expect(linesOf(b1).some((line) => (line[4] ?? 0) > 19)).toBe(false);
    const longer = { ...stroke, points: [[100, 850], [700, 850]] } as const; // prettier-ignore
    const [, , second, third] = pagesOf(course([longer]), 'a4-tiles');
    expect(second && linesOf(second).filter(nearTo([110 - 267, 60, 710 - 267, 60, 20]))).toHaveLength(1);
    expect(third && linesOf(third).filter(nearTo([110 - 534, 60, 710 - 534, 60, 20]))).toHaveLength(1);
  });

  it('shows the edges of a turned zone where it lies, to 0.1 mm', () => {
    const zone = { at: [200, 700], size: [100, 60], angle: 90, round: false, number: 0, blocks: 0 } as const;
    const [page] = pagesOf(course([{ type: 'target', id: 'z', ...zone }]), 'exact');
    const edges = page ? linesOf(page) : [];
    // 200 mm below the upper edge of the arena, and 10 mm of margin; 60 mm wide and 100 mm high as it is turned.
    for (const x of [180, 240]) expect(edges.some(([x1 = 0, y1 = 0, x2 = 0, y2 = 0]) =>
      Math.abs(x1 - x) < 0.1 && Math.abs(x2 - x) < 0.1 && Math.abs(y1 + y2 - 420) < 0.1 && Math.abs(Math.abs(y1 - y2) - 100) < 0.1)).toBe(true); // prettier-ignore
  });

  it('has a ruler of 100 mm on each sheet', () => {
    for (const page of pagesOf(course([]), 'a4-tiles'))
      expect(linesOf(page).filter(([x1 = 0, y1, x2 = 0, y2]) => y1 === y2 && Math.abs(x2 - x1 - 100) < 0.01)).toHaveLength(1); // prettier-ignore
  });

  it('is cut off where the sheet ends, so that nothing is printed into the margin', () => {
    const [page] = pagesOf(course([stroke], [400, 277]), 'a3');
    const clip = /([\d.]+) ([\d.]+) ([\d.]+) (-?[\d.]+) re\nW\nn/.exec(page?.operators ?? '');
    expect([1, 3, 4].map((i) => mm(clip?.[i]))).toEqual([
      expect.closeTo(10, 2),
      expect.closeTo(400, 2),
      expect.closeTo(-277, 2),
    ]);
  });

  it('fits on one sheet of the size of the arena and its margin', () => {
    const pages = pagesOf(course([stroke]), 'exact');
    expect(pages.map(({ sizeMm }) => sizeMm.map(Math.round))).toEqual([[1220, 920]]);
    expect(pages[0] && linesOf(pages[0]).filter(nearTo([110, 60, 260, 60, 20]))).toHaveLength(1);
  });

  it('prints everything that a course may hold', () => {
    const box = { at: [300, 200], size: [100, 60], angle: 45 } as const;
    const objects: readonly SceneObject[] = [
      { type: 'wall', id: 'c', from: [0, 0], to: [300, 400], thickness: 10 },
      { type: 'block', id: 'd', ...box },
      { type: 'mover', id: 'g', ...box, to: [500, 200], speed: 100, spiked: true },
      { type: 'target', id: 'i', ...box, round: true, number: 0, blocks: 2 },
      { type: 'checkpoint', id: 'j', ...box, round: false, number: 12, blocks: 0 },
      { type: 'forbidden', id: 'k', ...box, round: false, number: 0, blocks: 0 },
      { type: 'label', id: 'l', at: [600, 700], text: 'Zürich → (1)', height: 30, angle: 90 },
    ];
    const [page] = pagesOf(course(objects), 'exact');
    expect(page?.operators).not.toMatch(/NaN|undefined|Infinity/);
    expect(page?.operators).toContain('(Zürich -> \\(1\\)) Tj');
    expect(page?.operators).toMatch(/ c\n/); // the round zone is made of curves
  });
});

describe('the task of a course in its print', () => {
  const task: PaperTask = {
    ...{ title: 'Œuvre d’été', text: 'Fahre **links** mit `left()`.', picture: null, goalsTitle: 'Ziel' },
    ...{ goals: ['Erreiche das Ziel'], rules: [], checksTitle: '', checks: [], stars: [], hints: [] },
  };

  it('has a sheet of A4 of its own behind all others', () => {
    const pages = pagesOf(course([stroke]), 'exact', task);
    expect(pages.map(({ sizeMm }) => sizeMm.map(Math.round))).toEqual([[1220, 920], [210, 297]]); // prettier-ignore
    expect(pages[1]?.operators).toContain('(\u008cuvre d\u0092été) Tj');
    for (const words of ['Fahre', 'links', 'left\\(\\)', 'Ziel', 'Erreiche das Ziel'])
      expect(pages[1]?.operators).toContain(`(${words}) Tj`);
    expect(pages[1]?.operators).not.toMatch(/NaN|undefined|Infinity/);
  });

  it('goes on on further sheets, none of which writes into its margin', () => {
    const pages = pagesOf(course([]), 'exact', { ...task, text: 'Ein Absatz mit Wörtern.\n\n'.repeat(60) }).slice(1);
    expect(pages).toHaveLength(3);
    pages.forEach(({ operators }, index) => {
      expect(operators).toContain(`(${String(index + 1)}/3) Tj`);
      for (const [, x, y] of operators.matchAll(/([\d.]+) ([\d.]+) Td/g)) {
        expect(mm(x)).toBeGreaterThanOrEqual(19.9);
        expect(mm(y)).toBeGreaterThanOrEqual(9.9); // the foot
        expect(mm(y)).toBeLessThanOrEqual(277);
      }
    });
  });
});

describe('what a sheet takes of a long line', () => {
  const shown = { minX: 0, maxX: 100, minY: 0, maxY: 100 };

  it('is each run of pieces that come near it', () => {
    const points = [[-300, 50], [-200, 50], [50, 50], [50, 300], [200, 300], [200, 50], [90, 50]] as const; // prettier-ignore
    expect(runsWithin(points, shown)).toEqual([
      [[-200, 50], [50, 50], [50, 300]], // prettier-ignore
      [[200, 50], [90, 50]], // prettier-ignore
    ]);
  });

  it('is a dot for a line of one place', () => {
    expect(runsWithin([[5, 5]], shown)).toEqual([[[5, 5], [5, 5]]]); // prettier-ignore
    expect(runsWithin([[500, 5]], shown)).toEqual([]);
  });

  it('has signs that every reader can show, and no emojis', () => {
    expect(printable('Grüsse 🚗👩🏽‍🏫 → ♞')).toBe('Grüsse  -> ?');
    expect(printable('“Fit” …')).toBe('“Fit” …');
  });

  it('shows no question mark for what German, French and Italian need: quotes, œ, narrow spaces', () => {
    expect(printable('„So“, Plan\u202f: 3 × 2 – «\u202fcœur\u202f», perché l’è')).toBe(
      '„So“, Plan\u00a0: 3 × 2 – «\u00a0cœur\u00a0», perché l’è',
    );
  });

  it('writes them as one byte each, as the fonts have them', () => {
    const [page] = pagesOf(course([{ type: 'label', id: 'l', at: [600, 700], text: 'œ “é” – ’', height: 30, angle: 0 }]), 'exact'); // prettier-ignore
    expect(page?.operators).toContain('(\u009c \u0093é\u0094 \u0096 \u0092) Tj'); // Windows-1252
  });
});
