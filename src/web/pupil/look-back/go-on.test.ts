// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';

import { createPage, type TestPage } from '../../app/testing/page';
import { show, startRun } from '../../app/testing/run';
import { t } from '../../kit/i18n';
import { goOnFromHere } from './go-on';
import words from './words';

let page: TestPage;
/** The programs of the runs so far. */
const ran = (): unknown[] =>
  page.sent.flatMap((message) => (message.type === 'run' ? [message.setup.devices[0]?.files['main.py']] : []));
/** Gives the answer with these words. */
function answer(text: string): void {
  const { value } = page.dialogs.current;
  if (value?.kind !== 'choose') throw new Error('There is no question.');
  value.choices.find(({ key }) => t(key) === text)?.run();
}

beforeEach(async () => {
  page = createPage();
  page.work.setText('main.py', 'x = 1\n');
  await startRun(page);
  await show(page, { timeUs: 1_000_000 });
  page.run.look.back();
  page.say({ type: 'inputs', inputs: [], nowUs: 1_000_000 });
});

describe('going on from a moment of the past', () => {
  it('asks nothing as long as the program is the one that ran', async () => {
    goOnFromHere(page);
    await expect.poll(ran).toEqual(['x = 1\n', 'x = 1\n']);
    expect(page.dialogs.current.value).toBeNull();
  });

  it('asks which program goes on once it was changed: that of then goes on from here', async () => {
    page.work.setText('main.py', 'x = 2\n');
    goOnFromHere(page);
    answer(t(words.asItRan));
    await expect.poll(ran).toEqual(['x = 1\n', 'x = 1\n']);
    expect(page.sent.findLast(({ type }) => type === 'run')).toMatchObject({ catchUpUs: 1_000_000 });
  });

  it('begins the changed one at its start', async () => {
    page.work.setText('main.py', 'x = 2\n');
    goOnFromHere(page);
    expect(ran()).toHaveLength(1);
    answer(t(words.anew));
    await expect.poll(ran).toEqual(['x = 1\n', 'x = 2\n']);
    expect(page.run.past.value).toBeNull();
  });
});
