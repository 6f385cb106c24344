// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { afterEach, beforeAll, describe, expect, it, vi } from 'vitest';

import { classResult } from '#check/report/class-result';
import { sceneWith, targetAt, taskWith } from '#check/testing/tasks';
import { classToText } from '#school-class/class-file';
import { usualScale } from '#school-class/grades';
import { newClass } from '#school-class/school-class';
import { aResult } from '#school-class/testing/class';

import { createPage } from '../../app/testing/page';
import { loadTexts } from '../../kit/i18n';
import { stubDatabase } from '../../session/work/storage/testing/memory-database';
import { saveTable } from './save-report';

beforeAll(() => loadTexts('de'));
afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

const task = taskWith(sceneWith([targetAt(600, 450)]));
const found = classResult('t', [{ name: 'Ada', result: aResult(1) }], 'de');
const kept = (...names: readonly string[]) => {
  const database = stubDatabase();
  for (const [place, name] of names.entries()) {
    const text = classToText({ ...newClass(name), scale: usualScale('ch6') });
    database.entries.set(`classes.${place}`, { name: `classes.${place}`, usedMs: Infinity, text });
  }
  const saved: Blob[] = [];
  vi.spyOn(URL, 'createObjectURL').mockImplementation((blob) => `blob:${saved.push(blob as Blob)}`);
  return { database, saved };
};

describe('the table of a class', () => {
  it('has its grades the first time, too, however slowly the browser reads the class', async () => {
    const { database, saved } = kept('8b');
    database.hold();
    const saving = saveTable(createPage(), found, task, []);
    await flushPromises();
    expect(saved).toHaveLength(0);
    database.release();
    await saving;
    expect(await saved[0]!.text()).toContain('Note (8b)');
  });

  it('has none by the scale of some class: one of several is chosen before', async () => {
    const { saved } = kept('8a', '8b');
    await saveTable(createPage(), found, task, []);
    expect(await saved[0]!.text()).not.toContain('Note');
  });
});
