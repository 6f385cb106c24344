// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import { defineComponent, h } from 'vue';

import { part } from './part';

const [provideLamp, useLamp] = part<{ readonly watts: number }>('lamp');
const Shade = defineComponent({
  setup() {
    const { watts } = useLamp();
    return () => h('p', `${watts} W`);
  },
});

describe('a slot for the models of a room', () => {
  it('hands what was put in to the components below', () => {
    const Room = defineComponent({
      setup() {
        provideLamp({ watts: 9 });
        return () => h(Shade);
      },
    });
    expect(mount(Room).text()).toBe('9 W');
  });

  it('says which room is missing when nobody has filled it', () => {
    const quiet = { global: { config: { warnHandler: () => undefined } } };
    expect(() => mount(Shade, quiet)).toThrow('Nothing is provided for the room lamp.');
  });
});
