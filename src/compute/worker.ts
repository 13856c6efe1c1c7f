/** The entry of every worker: what it is for is decided by the first call. */
import { serve } from './remote/serve.ts';
import { services } from './services/services.ts';

serve(self, services);
