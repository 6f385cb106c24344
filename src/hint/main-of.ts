import type { HandIn } from '#check/hand-in/hand-in';
import { runFilesOf } from '#project/devices';
import { MAIN } from '#project/project';

/** The program of the first device. */
export const mainOf = ({ project }: HandIn): string => runFilesOf(project, 0)[MAIN] ?? '';
