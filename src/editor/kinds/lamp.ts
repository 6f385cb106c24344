import { LAMP_MM, lampOutline } from '#scene/kinds/lamp';
import { lampColors, sceneDefaults, sceneLimits, type Lamp, type LampColor } from '#scene/scene';
import { switchWays } from '#scene/kinds/switching';
import { lengthField, placeFields } from '../object-fields';
import { toPoint, toVec, turnedAbout } from '../plane';
import { hitWithin, mirroredPoint, scaledPoint, shifted, type EditorKind } from './kind';
import { switchFields } from './switch-fields';

const moved = (lamp: Lamp, dx: number, dy: number): Lamp => ({ ...lamp, at: shifted(lamp.at, dx, dy) });

/** Lamps: moved, never sized. */
export const lamp: EditorKind<Lamp> = {
  layer: 3,
  place: ({ at }) => at,
  span: () => null,
  middle: ({ at }) => toVec(at),
  extentMm: () => LAMP_MM,
  ...hitWithin<Lamp>(lampOutline),
  moved,
  turned: (lamp, pivot, angleDeg) => ({ ...lamp, at: toPoint(turnedAbout(toVec(lamp.at), pivot, angleDeg)) }),
  mirrored: (lamp, axis, atMm) => ({ ...lamp, at: mirroredPoint(lamp.at, axis, atMm) }),
  scaled: (lamp, about, factor) => ({ ...lamp, at: scaledPoint(lamp.at, about, factor) }),
  handles: () => [],
  fields: (lamp) => [
    {
      ...{
        kind: 'number',
        name: 'brightness',
        value: lamp.brightness,
        ...sceneLimits.brightnessCd,
        step: 5,
        unit: 'cd',
      },
      with: (brightness: number) => ({ ...lamp, brightness }),
    },
    lengthField('height', lamp.height, sceneLimits.lampMm, 10, (height) => ({ ...lamp, height })),
    {
      ...{ kind: 'choice', name: 'lampColor', value: lamp.color ?? 'warm', choices: ['warm', ...lampColors] },
      with: (color: LampColor | 'warm') => withColor(lamp, color),
    },
    ...switchFields(lamp.on, ['always', ...switchWays], (on) => {
      const { on: _on, ...rest } = lamp;
      return on === undefined ? rest : { ...rest, on };
    }),
    ...placeFields(lamp, lamp.at, moved),
  ],
  made: (id, at) => ({
    ...{ type: 'lamp', id, at },
    ...{ height: sceneDefaults.lampHeight, brightness: sceneDefaults.brightness },
  }),
};

function withColor(lamp: Lamp, color: LampColor | 'warm'): Lamp {
  const { color: _color, ...rest } = lamp;
  return color === 'warm' ? rest : { ...rest, color };
}
