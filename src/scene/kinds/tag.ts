import { pair, property } from '../json-text';
import { boxOutline, type Outline } from '../outline';
import { sceneDefaults, type Tag } from '../scene';
import { filling, type SceneKind } from './kind';
import { tagSheetMm } from './tag-thing';

/** Tags. */
export const tag: SceneKind<Tag> = {
  name: 'tag',
  write: ({ at, number, side, angle, flat }, rotation) => [
    `"at": ${pair(at)}`,
    `"number": ${String(number)}`,
    ...property('side', side, sceneDefaults.tagSide),
    ...rotation(angle),
    ...property('flat', flat ?? false, false),
  ],
  solid: () => [],
  ...filling(tagOutline),
};

/** Depth of what shows a standing tag from above, in mm. Chosen: a finger hits it. */
export const STANDING_TAG_MM = 16;

/** The outline of a tag from above, in world mm. */
export function tagOutline({ at, side, angle, flat }: Tag): Outline {
  const sheet = tagSheetMm(side);
  return boxOutline({ at, size: [flat === true ? sheet : STANDING_TAG_MM, sheet], angle });
}
