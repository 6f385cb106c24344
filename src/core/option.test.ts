import { describe, expect, it } from 'vitest';
import { completeOptions, optionProblem, type Option } from './option';

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
});
