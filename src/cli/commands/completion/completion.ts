import { readyIds } from '../../ready-courses';
import type { Shell } from '../help-arguments';
import { listsWith } from '../lists';
import { bashCompletion } from './bash';
import { zshCompletion } from './zsh';

/** The script that lets a shell complete `parcours` and `npx parcours`. */
export const completionFor = (shell: Shell): string =>
  ({ bash: bashCompletion, zsh: zshCompletion })[shell](listsWith(readyIds()));
