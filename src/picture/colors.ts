import type { PaintColor } from '#scene/paint/paint';

/** The colours of a course and of what is in it. */
export interface CourseColors {
  readonly floor: string;
  readonly strokes: Readonly<Record<PaintColor, string>>;
  /** Around white, yellow and silver strokes, which a light floor would swallow. */
  readonly strokeEdge: string;
  readonly movable: string;
  readonly movableLight: string;
  readonly movableInk: string;
  readonly fixed: string;
  readonly fixedInk: string;
  readonly fixedEdge: string;
  readonly wall: string;
  readonly wallLight: string;
  readonly wallInk: string;
  /** A target's edge and sign, and its ground. */
  readonly target: string;
  readonly targetFill: string;
  readonly checkpoint: string;
  readonly checkpointFill: string;
  readonly forbidden: string;
  readonly forbiddenFill: string;
  /** Ground of a zone's sign. */
  readonly signGround: string;
  /** A reached checkpoint or target. */
  readonly reached: string;
  readonly spikes: string;
  readonly spikesInk: string;
  readonly mover: string;
  readonly moverLight: string;
  readonly moverInk: string;
  readonly label: string;
}

/** On a light page and on paper. Every pair of sign and ground has a contrast of 3:1 at least, text 4.5:1. */
export const lightColors: CourseColors = {
  floor: '#FBFAF7',
  strokes: {
    black: '#17191C',
    gray: '#8B8F94',
    white: '#FFFFFF',
    red: '#D3313B',
    yellow: '#F7CE1B',
    green: '#2C8A4F',
    blue: '#2460C4',
    orange: '#E07A1F',
    purple: '#8E4FBD',
    brown: '#8A5A2E',
    silver: '#CBD3DB',
  },
  strokeEdge: '#C9C5BC',
  movable: '#A9DEC5',
  movableLight: '#BCE8D3',
  movableInk: '#0A5A41',
  fixed: '#B3282D',
  fixedInk: '#FFFFFF',
  fixedEdge: '#5C0F13',
  wall: '#4B5563',
  wallLight: '#5A6575',
  wallInk: '#8993A1',
  target: '#2563B8',
  targetFill: 'rgba(37, 99, 184, 0.11)',
  checkpoint: '#0B6E7C',
  checkpointFill: 'rgba(11, 110, 124, 0.1)',
  forbidden: '#B3282D',
  forbiddenFill: 'rgba(179, 40, 45, 0.1)',
  signGround: '#FFFFFF',
  reached: '#1B7A3A',
  spikes: '#23272E',
  spikesInk: '#FFC83D',
  mover: '#F4C430',
  moverLight: '#FAD766',
  moverInk: '#4A3200',
  label: '#2A3038',
};

/** On a dark page. The floor stays light: the line sensors see light and dark. */
export const darkColors: CourseColors = {
  floor: '#D3D6DA',
  strokes: {
    black: '#131518',
    gray: '#75797E',
    white: '#F4F5F6',
    red: '#BC2730',
    yellow: '#E3BA10',
    green: '#237541',
    blue: '#1C4FA6',
    orange: '#CF6D18',
    purple: '#7F43AC',
    brown: '#7A4E27',
    silver: '#B9C2CB',
  },
  strokeEdge: '#AEB3BA',
  movable: '#8CCBAF',
  movableLight: '#9DD6BD',
  movableInk: '#07442F',
  fixed: '#A32329',
  fixedInk: '#FFFFFF',
  fixedEdge: '#540D11',
  wall: '#3C4653',
  wallLight: '#4A5564',
  wallInk: '#8590A0',
  target: '#1B4F99',
  targetFill: 'rgba(37, 99, 184, 0.17)',
  checkpoint: '#085662',
  checkpointFill: 'rgba(11, 110, 124, 0.16)',
  forbidden: '#9A1F24',
  forbiddenFill: 'rgba(179, 40, 45, 0.15)',
  signGround: '#F4F5F6',
  reached: '#14612D',
  spikes: '#1B1F25',
  spikesInk: '#F5BE35',
  mover: '#DDB02A',
  moverLight: '#E8C252',
  moverInk: '#3D2A00',
  label: '#1F252C',
};
