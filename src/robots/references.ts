import type { RobotReference } from '#reference/types';
import { maqueenLiteReference } from './maqueen-lite/reference';

/** What the editor knows about the libraries of robots. Apart from `index.ts`, as only the editor needs it, and later. */
export const robotReferences: readonly RobotReference[] = [maqueenLiteReference];
