import { describe, expect, it, vi } from 'vitest';

import { handInOfFiles } from '#check/hand-in/read-hand-in';
import { brokenSource } from '#intake/sources';
import { htmlOf } from '#check/report/html';
import { csvOf } from '#check/report/texts';
import { ahead, sceneWith, targetAt, taskWith } from '#check/testing/tasks';

import { FirmwareError } from '../../../session/run/worker/firmware-trouble';
import { classWith, program } from './testing/class';

const task = taskWith(sceneWith([targetAt(700, 450)]));

describe('a class', () => {
  it('is checked as soon as there are a task and hand-ins', async () => {
    const { model, passed } = classWith();
    await model.add([program('Ada', ahead(3000)), program('Ben', 'x = 1')]);
    expect(passed()).toEqual([['Ada', null], ['Ben', null]]); // prettier-ignore
    await model.choose({ name: 'T', from: 'open', task });
    expect(passed()).toEqual([['Ada', true], ['Ben', false]]); // prettier-ignore
    expect(model.isChecking.value).toBe(false);
  });

  it('checks only what is new, and everything again for another task', async () => {
    const { model, asked } = classWith();
    await model.choose({ name: 'T', from: 'open', task });
    await model.add([program('Ada', ahead(3000))]);
    await model.add([program('Ben', 'x = 1')]);
    expect(asked).toHaveLength(2);
    await model.choose({ name: 'U', from: 'open', task });
    expect(asked).toHaveLength(4);
  });

  it('has points set by hand until they are taken back, or another task is chosen', async () => {
    const { model } = classWith();
    await model.choose({ name: 'T', from: 'open', task });
    await model.add([program('Ada', ahead(3000)), program('Ben', 'x = 1')]);
    const marks = () => model.found.value.handIns.map(({ marked }) => marked);
    model.mark('Ben', 0.5);
    model.mark('Ada', 0);
    expect(marks()).toEqual([0, 0.5]);
    expect(await model.keptRow(model.rows.value[1]!)).toMatchObject({ name: 'Ben', marked: 0.5 });
    model.mark('Ada', null);
    expect(marks()).toEqual([undefined, 0.5]);
    await model.choose({ name: 'U', from: 'open', task });
    expect(marks()).toEqual([undefined, undefined]);
  });

  it('gives each of several with one name its own, tells of twins and of what cannot be read', async () => {
    const { model } = classWith();
    await model.choose({ name: 'T', from: 'open', task });
    await model.add([program('Ada', ahead(3000)), brokenSource('Tim', { code: 'zip', params: {} })]);
    await model.add([program('Ada', ahead(3000))]);
    const told = model.found.value.handIns.map(({ name, result }) => [name, result.remarks.map(({ code }) => code)]);
    expect(told).toEqual([['Ada', ['twins']], ['Ada (2)', ['twins']], ['Tim', ['unreadable']]]); // prettier-ignore
  });

  it('asks which of several files is the program, and has no result for it until somebody has chosen', async () => {
    const { model, passed, asked } = classWith();
    await model.choose({ name: 'T', from: 'open', task });
    const files = { 'main.py': 'x = 1', 'versuch2.py': ahead(3000) };
    const choices = Object.entries(files).map(([file, text]) => ({
      file,
      handIn: handInOfFiles([{ name: 'main.py', text }]),
    }));
    const content = { problem: { code: 'several', params: { files: 'main.py, versuch2.py' } }, choices } as const;
    await model.add([{ name: 'Tim', read: () => content }, program('Ada', ahead(3000))]);
    const [tim] = model.rows.value;
    expect([tim?.choices?.map(({ file }) => file), tim?.handIn, asked.length]).toEqual([['main.py', 'versuch2.py'], null, 1]); // prettier-ignore
    const kept = await model.keptRow(tim!);
    await model.take('Tim', choices[1]!);
    expect(passed()).toEqual([['Tim', true], ['Ada', true]]); // prettier-ignore
    expect(await model.keptRow(model.rows.value[0]!)).toMatchObject({ content: { handIn: choices[1]!.handIn } });
    // A class that is brought back asks the same.
    model.restore(null, [kept]);
    expect(model.rows.value[0]?.choices).toHaveLength(2);
  });

  it('shows names without what a platform has added, each once', async () => {
    const { model } = classWith();
    await model.choose({ name: 'T', from: 'open', task });
    const [file, text] = ['Weiss Tim_7_assignsubmission_file_main', 'Weiss Tim_7_assignsubmission_onlinetext_'];
    await model.add([program(file, 'x = 1'), program(text, 'y = 1')]);
    expect(model.rows.value.map(({ shown }) => shown)).toEqual(['Weiss Tim', 'Weiss Tim (2)']);
    expect(model.found.value.handIns.map(({ name, shown }) => [name, shown])).toEqual([[file, 'Weiss Tim'], [text, 'Weiss Tim (2)']]); // prettier-ignore
  });

  it('has notes, which stay when it is checked for another task, and are in table and report', async () => {
    const { model } = classWith();
    await model.choose({ name: 'T', from: 'open', task });
    await model.add([program('Ada', ahead(3000)), program('Ben', 'x = 1')]);
    model.write('Ada', 'Schön gelöst, <b>Ada</b>!');
    await model.choose({ name: 'U', from: 'file', task });
    expect(model.found.value.handIns.map(({ note }) => note)).toEqual(['Schön gelöst, <b>Ada</b>!', '']);
    const [head, ada, ben] = csvOf(model.found.value, 'de').split('\r\n');
    expect([head, ada, ben].map((line) => line?.split(',').slice(-2).join())).toEqual([
      'Bemerkungen,Notiz',
      '"Schön gelöst, <b>Ada</b>!"',
      ',',
    ]);
    const report = htmlOf(model.found.value, task, 'de');
    expect(report.split('Schön gelöst, &lt;b&gt;Ada&lt;/b&gt;!')).toHaveLength(3); // in the table, and on Ada's sheet
  });

  it('comes back with results and notes when it was taken away by mistake, unless something was handed in since', async () => {
    const { model, passed, asked } = classWith();
    await model.choose({ name: 'T', from: 'open', task });
    await model.add([program('Ada', ahead(3000)), program('Ben', 'x = 1')]);
    model.write('Ada', 'gut');
    const bringBack = model.clear();
    expect(model.rows.value).toEqual([]);
    bringBack();
    expect(passed()).toEqual([['Ada', true], ['Ben', false]]); // prettier-ignore
    expect([model.rows.value[0]?.note, asked.length]).toEqual(['gut', 2]);
    const late = model.clear();
    await model.add([program('Cleo', 'y = 1')]);
    late();
    expect(passed()).toEqual([['Cleo', false]]);
  });

  it('is unsaved as soon as there is a result or a note, until a table or report has it', async () => {
    const { model } = classWith();
    await model.add([program('Ada', ahead(3000))]);
    expect(model.isUnsaved.value).toBe(false); // the file is still where it came from
    model.write('Ada', 'gut');
    expect(model.isUnsaved.value).toBe(true);
    model.noteSaved();
    expect(model.isUnsaved.value).toBe(false);
    await model.choose({ name: 'T', from: 'open', task });
    expect(model.isUnsaved.value).toBe(true);
    model.clear();
    expect(model.isUnsaved.value).toBe(false);
  });

  it('is gone for good if it is taken away while it is checked', async () => {
    const { model } = classWith({ starter: () => new Promise(() => undefined) });
    await model.choose({ name: 'T', from: 'open', task });
    void model.add([program('Ada', ahead(3000))]);
    expect(model.isChecking.value).toBe(true);
    model.clear();
    expect([model.rows.value, model.isChecking.value]).toEqual([[], false]);
  });

  it('says when nothing can be checked, and tries again with the next hand-in', async () => {
    const starter = vi.fn().mockRejectedValue(new Error('offline'));
    const { model } = classWith({ starter });
    await model.choose({ name: 'T', from: 'open', task });
    await model.add([program('Ada', ahead(3000))]);
    expect([model.failure.value, model.isChecking.value]).toEqual(['notice.firmware', false]);
    await model.add([program('Ben', ahead(3000))]);
    expect(starter).toHaveBeenCalledTimes(2);
  });

  it.each([
    ['forbidden', 'notice.firmwarePolicy'],
    ['foreign', 'notice.firmwareForeign'],
    ['absent', 'notice.firmware'],
  ] as const)('says why nothing can be checked, as a run does: the VM is %s', async (trouble, said) => {
    const { model } = classWith({ starter: () => Promise.reject(new FirmwareError(trouble)) });
    await model.choose({ name: 'T', from: 'open', task });
    await model.add([program('Ada', ahead(3000))]);
    expect(model.failure.value).toBe(said);
  });
});
