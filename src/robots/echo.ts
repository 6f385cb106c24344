import { optionOf, type Option, type OptionValues } from '#core/option';
import type { HcSr04Options } from '#devices/hc-sr04';
import robotWords from './words';

const words = robotWords.echo;

/** The option for what a robot's ultrasonic sensor does when nothing is in range: sensors of both kinds are sold. */
export const echoOption: Option = optionOf('echo', words, ['none', 'long-pulse'], { isExpert: true });

/** The sensor's choices that these options mean. */
export const echoOf = ({ echo }: OptionValues): HcSr04Options => ({
  withoutTarget: echo === 'long-pulse' ? 'long-pulse' : 'none',
});
