// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import { h, nextTick } from 'vue';

import { controls } from '../controls/controls';
import AddSelect from './AddSelect.vue';
import CheckField from './CheckField.vue';
import NumberField from './NumberField.vue';
import SegmentField from './SegmentField.vue';
import SelectField from './SelectField.vue';
import TextField from './TextField.vue';

const global = { plugins: [controls] };
const options = () => ['a', 'b'].map((value) => h('option', { value }, value));

describe('a number', () => {
  const base = { label: 'Breite', unit: 'cm', value: 50, min: 10, max: 400 };

  it('takes effect with every key that makes sense, and says what does not', async () => {
    const field = mount(NumberField, { props: { ...base, isOptional: true }, global });
    const input = field.get('input');
    expect(input.attributes('role')).toBeUndefined();
    await input.setValue('60');
    await input.setValue('6000');
    expect(field.get('[role=alert]').text()).toContain('400');
    expect(input.attributes('aria-describedby')).toBe(field.get('[role=alert]').attributes('id'));
    await input.setValue('');
    expect(field.emitted('change')).toEqual([[60], [null]]);
  });

  it('is not given away empty where it has to be there', async () => {
    const field = mount(NumberField, { props: base, global });
    await field.get('input').setValue('');
    expect(field.emitted('change')).toBeUndefined();
    await field.get('input').trigger('blur');
    expect(field.get('input').element.value).toBe('50');
  });

  it('takes effect on Enter within its limits where it is lazy, and is stepped by the arrow keys', async () => {
    const field = mount(NumberField, { props: { ...base, lazy: true, per: 10, step: 5, buttons: true }, global });
    const input = field.get('input');
    expect(input.element.value).toBe('5');
    expect(input.attributes()).toMatchObject({ role: 'spinbutton', 'aria-valuenow': '5', 'aria-valuemax': '40' });
    input.element.value = '70';
    await input.trigger('input');
    expect(field.emitted('change')).toBeUndefined();
    await input.trigger('keydown', { key: 'Enter' });
    await input.trigger('keydown', { key: 'ArrowUp' });
    await field.findAll('button')[0]?.trigger('click');
    expect(field.emitted('change')).toEqual([[400], [55], [45]]);
  });

  it('shows words where several things differ in it', () => {
    const field = mount(NumberField, { props: { ...base, lazy: true, mixed: 'verschieden' }, global });
    expect(field.get('input').element.value).toBe('');
    expect(field.get('input').attributes()).toMatchObject({
      placeholder: 'verschieden',
      'aria-valuetext': 'verschieden',
    });
  });
});

describe('a text', () => {
  it('tells of every key and of its end, on one line or on several', async () => {
    const field = mount(TextField, {
      props: { label: 'Name', value: 'a' },
      attrs: { 'data-testid': 'name', class: 'wide' },
    });
    const input = field.get('input');
    expect([input.attributes('data-testid'), input.classes(), field.classes()]).toEqual([
      'name',
      ['form-box'],
      ['form-field', 'wide'],
    ]);
    input.element.value = 'ab';
    await input.trigger('input');
    await input.trigger('change');
    expect([field.emitted('input'), field.emitted('change')]).toEqual([[['ab']], [['ab']]]);
    await field.setProps({ rows: 3 });
    expect(field.get('textarea').element.value).toBe('a');
    expect(field.element.tagName).toBe('LABEL');
  });
});

describe('a list to choose from', () => {
  it('shows its value again where a choice changed nothing', async () => {
    const field = mount(SelectField, { props: { label: 'Art', value: 'a' }, slots: { default: options } });
    await field.get('select').setValue('b');
    await nextTick();
    expect(field.emitted('change')).toEqual([['b']]);
    expect(field.get('select').element.value).toBe('a');
    await field.setProps({ value: 'b' });
    expect(field.get('select').element.value).toBe('b');
  });

  it('shows its own name always where a choice adds something', async () => {
    const field = mount(AddSelect, { props: { label: 'Prüfung' }, slots: { default: options } });
    await field.get('select').setValue('b');
    await nextTick();
    expect(field.emitted('add')).toEqual([['b']]);
    expect([field.get('select').element.value, field.get('option').text()]).toEqual(['', '+ Prüfung']);
  });
});

describe('a box to tick', () => {
  it('says whether it is ticked, or neither', async () => {
    const field = mount(CheckField, { props: { label: 'Alle', about: 'Auch neue.', checked: false, isMixed: true } });
    expect(field.get('input').element.indeterminate).toBe(true);
    expect(field.text()).toBe('AlleAuch neue.');
    await field.get('input').setValue(true);
    expect(field.emitted('change')).toEqual([[true]]);
  });

  it('may be one of a group', () => {
    const field = mount(CheckField, {
      props: { label: 'A4', checked: true, type: 'radio' },
      attrs: { name: 'paper', value: 'a4' },
    });
    expect(field.get('input').attributes()).toMatchObject({ type: 'radio', name: 'paper', value: 'a4' });
  });
});

describe('a choice of a few words side by side', () => {
  it('is a group of radio buttons with a name, and gives away what is chosen', async () => {
    const choices = ['cm', 'mm'].map((id) => ({ id, label: id }));
    const field = mount(SegmentField, { props: { legend: 'Einheit', value: 'cm', choices, testId: 'unit' }, global });
    expect(field.get('legend').text()).toBe('Einheit');
    const radios = field.findAll<HTMLInputElement>('input[type=radio]');
    expect(radios.map(({ element }) => [element.value, element.checked, element.name])).toEqual([
      ['cm', true, radios[1]?.element.name],
      ['mm', false, radios[0]?.element.name],
    ]);
    await radios[1]?.setValue();
    expect(field.emitted('choose')).toEqual([['mm']]);
  });
});
