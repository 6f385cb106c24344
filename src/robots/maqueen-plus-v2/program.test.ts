import { describeEffects } from '../testing/maqueen-effects';
import { maqueenPlusV2Build } from './robot';

describeEffects({ build: maqueenPlusV2Build, module: 'mbrobot_plusV2', sonarMm: 76, ports: ['P0', 'P1', 'P2'] });
