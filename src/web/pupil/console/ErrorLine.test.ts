// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { beforeAll, describe, expect, it, vi } from 'vitest';

import { mountOn, named, setWindow, textOf } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { fetchAdvice } from './advice/explain';
import ErrorLine from './ErrorLine.vue';
import { useErrorLine } from './use-error-line';

const text = 'from mbrobot import *\n\nvorwärts()\n';
const report = {
  failure: { type: 'NameError', message: "name 'vorwärts' isn't defined", traceback: '' },
  source: { text, line: 3 },
  table: null,
};
const place = { file: 'main.py', line: 3 };

function phoneWith(program: string): TestPage {
  setWindow(390, 844);
  const page = createPage();
  const files = [{ name: 'main.py', text: program }];
  page.work.openProject({ files, scene: page.work.scene.value, course: null }, null);
  return page;
}

describe('the line of an error on a phone', () => {
  beforeAll(() => Promise.all([fetchAdvice(), import('./advice/late-advice')]));

  it('says the suggestion first, then the reason, and its button writes it', async () => {
    const page = phoneWith(text);
    const line = mountOn(page, ErrorLine, { place, report });
    await vi.waitFor(() => expect(line.find('.mend').text()).toBe('Ändern'));
    expect(textOf(line.get('.words').element)).toBe(
      'Zeile 3: Meinst du forward? Den Namen vorwärts kennt das Programm nicht.',
    );
    named('Ändern in forward').click();
    expect(page.jump.mending.value?.after).toBe('from mbrobot import *\n\nforward()\n');
  });

  it('opens the card by a tap on its words', async () => {
    const page = phoneWith(text);
    const line = mountOn(page, ErrorLine, { place, report });
    await line.get('.words').trigger('click');
    expect(page.layout.tab.value).toBe('console');
  });

  it('stands there from the error until the program is another or runs again', async () => {
    const page = phoneWith(text);
    let seen: ReturnType<typeof useErrorLine> | undefined;
    mountOn(page, { setup: () => ((seen = useErrorLine()), () => null) });
    expect(seen?.value).toBeNull();
    page.console.addError(place, report);
    expect(seen?.value?.place).toEqual(place);
    page.work.setText('main.py', text.replace('vorwärts', 'forward'));
    expect(seen?.value).toBeNull();
    page.work.setText('main.py', text);
    page.console.startRun(2);
    await flushPromises();
    expect(seen?.value).toBeNull();
  });
});
