import { describe, expect, it } from 'vitest';

import { createDialogs, type Question } from './dialogs';

const question = (name: string): Question => ({
  kind: 'choose',
  title: 'code.renameTitle',
  text: 'code.name',
  values: { file: name },
  choices: [],
});

describe('questions to the pupil', () => {
  it('are none at first, and closing none does nothing', () => {
    const dialogs = createDialogs();
    expect(dialogs.current.value).toBeNull();
    dialogs.close();
    expect(dialogs.current.value).toBeNull();
  });

  it('come one after the other in the order in which they were asked', () => {
    const dialogs = createDialogs();
    const [first, second, third] = [question('a'), question('b'), question('c')];
    for (const each of [first, second, third]) dialogs.ask(each);
    expect(dialogs.current.value).toBe(first);
    dialogs.close();
    expect(dialogs.current.value).toBe(second);
    dialogs.close();
    expect(dialogs.current.value).toBe(third);
    dialogs.close();
    expect(dialogs.current.value).toBeNull();
  });

  it('asked while an answer is under way wait behind those that were asked before', () => {
    const dialogs = createDialogs();
    dialogs.ask(question('a'));
    dialogs.ask(question('b'));
    dialogs.close();
    dialogs.ask(question('c'));
    expect(dialogs.current.value).toMatchObject({ values: { file: 'b' } });
    dialogs.close();
    expect(dialogs.current.value).toMatchObject({ values: { file: 'c' } });
  });
});
