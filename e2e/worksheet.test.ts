import { inflateSync } from 'node:zlib';
import decodeQR from 'qr/decode.js';
import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';
import { closedLine, isThere, openWork, programIn } from './page';
import { by, until } from './parts';
import { build, fromMenu } from './pupil';

/** The work of a teacher: a task with a start program, a model solution and a hidden world. */
function teachersWork(): string {
  const work = JSON.parse(closedLine()) as { readonly project: { readonly files: readonly object[] } };
  const task = {
    ...{ version: 1, id: 'line', checks: [{ id: 'goals', type: 'goals' }, { id: 'loop', type: 'loop' }] }, // prettier-ignore
    worlds: [
      { id: 'visible', hidden: false },
      { id: 'secret', seed: 7 },
    ],
    solution: work.project.files,
  };
  const files = [{ name: 'main.py', text: 'from mbrobot import *\n# Beginne hier\n' }];
  return JSON.stringify({ ...work, project: { ...work.project, files, task } });
}

/** Keeps what the page saves as a string of bytes. */
const watchPdf = (app: App): Promise<void> =>
  app.evaluate(() => {
    const kept = window as { pdf?: string };
    URL.createObjectURL = (object: Blob | MediaSource) => {
      const reader = new FileReader();
      reader.onload = () => (kept.pdf = reader.result as string);
      if (object instanceof Blob) reader.readAsDataURL(object);
      return 'data:,';
    };
    HTMLAnchorElement.prototype.click = () => undefined;
  });
const pdfOf = async (app: App): Promise<Buffer> => {
  const address = await app.evaluate(() => (window as { pdf?: string }).pdf ?? '');
  return Buffer.from(address.split(',')[1] ?? '', 'base64');
};

/** The drawing operators of all pages. */
function operatorsIn(pdf: Buffer): string {
  const text = pdf.toString('latin1');
  let all = '';
  for (const { index, 0: start } of text.matchAll(/stream\r?\n/g)) {
    const end = text.indexOf('endstream', index);
    try {
      all += inflateSync(pdf.subarray(index + start.length, end)).toString('latin1');
    } catch {
      continue; // not compressed like this: a picture
    }
  }
  return all;
}

/** Reads the code out of the rectangles that a page is filled with, painted with 300 dots an inch. */
function codeIn(operators: string): string {
  const dots = 300 / 72;
  const rectangles = [...operators.matchAll(/^(-?[\d.]+) (-?[\d.]+) (-?[\d.]+) (-?[\d.]+) re\nf$/gm)].map((found) =>
    found.slice(1).map(Number),
  );
  const [width, height] = [Math.ceil(595.3 * dots), Math.ceil(841.9 * dots)];
  const data = new Uint8Array(width * height * 4).fill(255);
  for (const [x = 0, y = 0, w = 0, h = 0] of rectangles) {
    const [top, bottom] = [841.9 - Math.max(y, y + h), 841.9 - Math.min(y, y + h)].map((at) => Math.round(at * dots));
    for (let row = top ?? 0; row < (bottom ?? 0); row += 1)
      data.fill(0, (row * width + Math.round(x * dots)) * 4, (row * width + Math.round((x + w) * dots)) * 4);
  }
  return decodeQR({ width, height, data });
}

/** The open work, as the page keeps it. */
const keptWork = (app: App): Promise<string> => app.evaluate(() => sessionStorage.getItem('parcours.work') ?? '');

test(
  'the code on a printed worksheet opens the task, without its solution and without the hidden world',
  IN_ONE_ENGINE,
  async ({ app }) => {
    test.setTimeout(90_000);
    await openWork(app, teachersWork());
    await build(app);
    await fromMenu(app, by('course-more'), by('editor-print'), () => isThere(app, by('print-dialog')));
    await app.click(by('print-sheet'));
    await until(app, by('sheet-page'));
    await watchPdf(app);
    await app.click(by('sheet-pdf'));
    await expect.poll(async () => (await pdfOf(app)).length, { timeout: 30_000 }).toBeGreaterThan(10_000);
    const operators = operatorsIn(await pdfOf(app));
    expect(operators).toMatch(/\((Closed line|Geschlossene Linie)\) Tj/);
    const link = codeIn(operators);
    expect(link).toMatch(/^https?:\/\/[^#]+#p=9\./);
    await app.evaluate(() => sessionStorage.clear());
    await app.goto('./logo.svg');
    await app.goto(`./#${link.split('#')[1] ?? ''}`);
    await expect.poll(() => keptWork(app), { timeout: 20_000 }).toContain('"loop"');
    expect(await programIn(app)).toContain('# Beginne hier');
    expect(await keptWork(app)).not.toMatch(/"solution"|"secret"|"hidden"|irLeft/);
  },
);
