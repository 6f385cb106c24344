import { describe, expect, it } from 'vitest';
import { completeOptions, isShownWith, optionProblem, type Option } from './option';

const title = { de: 'Titel', fr: 'titre', it: 'titolo', en: 'title' };
const options: readonly Option[] = [
  { id: 'S1', title, choices: ['none', 'claw'].map((id) => ({ id, title })) },
  { id: 'bumper', title, choices: ['when-read', 'always'].map((id) => ({ id, title })) },
];

describe('options of a robot', () => {
  it('have the first choice when nothing is chosen, or something unknown', () => {
    expect(completeOptions(options, {})).toEqual({ S1: 'none', bumper: 'when-read' });
    expect(completeOptions(options, { S1: 'claw', bumper: 'never', tail: 'long' })).toEqual({
      S1: 'claw',
      bumper: 'when-read',
    });
  });

  it('are fine when option and choice are known', () => {
    expect(optionProblem(options, { S1: 'claw' })).toBeNull();
  });

  it('name what is unknown, and what there is', () => {
    expect(optionProblem(options, { tail: 'long' })).toBe('there is no option "tail". Known: S1, bumper.');
    expect(optionProblem(options, { S1: 'laser' })).toBe('"laser" is no choice of S1. Known: none, claw.');
    expect(optionProblem([], { S1: 'claw' })).toBe('there is no option "S1". Known: none.');
  });

  it('may matter only while another one has a certain choice', () => {
    const height = {
      id: 'height',
      title,
      onlyWith: { option: 'S1', choices: ['claw'] },
      choices: [{ id: 'low', title }],
    };
    expect(['none', 'claw'].map((S1) => isShownWith(height, { S1 }))).toEqual([false, true]);
    expect(isShownWith(height, {})).toBe(false);
    expect(options.every((option) => isShownWith(option, {}))).toBe(true);
  });
});
