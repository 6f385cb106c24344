// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import { defineComponent, h } from 'vue';

import { lateParts, part } from './part';
import { LateModels } from './state/late-models';

interface Base {
  readonly late: LateModels;
  readonly name: string;
}
const [provideBase, useBase] = part<Base>('base');
const made: string[] = [];
const [upperOf, useUpper] = lateParts(useBase, ({ name }: Base) => {
  made.push(name);
  return { title: `above ${name}` };
});

/** A page whose component notes the upper models that it gets. */
function page(name: string) {
  const base: Base = { late: new LateModels(), name };
  const got: object[] = [];
  const Child = defineComponent(() => {
    got.push(useUpper());
    return () => null;
  });
  const Page = defineComponent(() => {
    provideBase(base);
    return () => [h(Child), h(Child)];
  });
  return { base, got, open: () => mount(Page) };
}

describe('models that a room makes itself', () => {
  it('are made once per page, when somebody asks, and are the same for components and functions', () => {
    const first = page('first');
    expect(made).toEqual([]);
    const upper = upperOf(first.base);
    expect(upper).toEqual({ title: 'above first' });
    first.open();
    expect(first.got).toHaveLength(2);
    for (const it of first.got) expect(it).toBe(upper);
    const second = page('second');
    second.open();
    expect(second.got[0]).toEqual({ title: 'above second' });
    expect(made).toEqual(['first', 'second']);
  });
});
