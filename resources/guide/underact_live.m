function ask = underact_live(port, token_file)
  % ask = underact_live(7171, FILE) connects; answer = ask('start') sends a request.
  if exist('OCTAVE_VERSION', 'builtin'), eval('pkg load instrument-control'), end
  socket = tcpclient('127.0.0.1', port);
  words = {'GET / HTTP/1.1', 'Host: 127.0.0.1', 'Connection: Upgrade', 'Upgrade: websocket', ...
           'Sec-WebSocket-Version: 13', 'Sec-WebSocket-Key: MDEyMzQ1Njc4OWFiY2RlZg==', '', ''};
  write(socket, uint8(strjoin(words, char([13 10]))));
  head = '';
  while isempty(strfind(head, char([13 10 13 10]))), head(end + 1) = char(read(socket, 1)); end
  ask = @(what, varargin) request(socket, what, varargin);
  ask('hello', 'token', strtrim(fileread(token_file)), 'name', 'matlab');
end

function answer = request(socket, what, keys)
  put(socket, 1, unicode2native(jsonencode(struct('id', 1, 'do', what, keys{:})), 'UTF-8'));
  answer = struct();
  while ~isfield(answer, 'id')  % ticks and events come in between
    [kind, bytes] = get_frame(socket);
    if kind == 1, answer = jsondecode(native2unicode(bytes, 'UTF-8')); end
    if kind == 8, error('The service has closed the connection.'), end
    if kind == 9, put(socket, 10, bytes), end  % it asks whether we are alive
  end
  if ~answer.ok, error('%s: %s', answer.problems(1).path, answer.problems(1).sentence), end
end

function put(socket, kind, bytes)
  count = numel(bytes);
  if count < 126, size_of = count; else, size_of = [126 floor(count / 256) mod(count, 256)]; end
  size_of(1) = size_of(1) + 128;  % masked, as every client's frame, with the mask 0
  write(socket, uint8([128 + kind, size_of, 0, 0, 0, 0, double(bytes(:)')]));
end

function [kind, bytes] = get_frame(socket)
  head = double(get_bytes(socket, 2));
  kind = mod(head(1), 16);
  count = head(2);
  if count == 126, count = sum([256 1] .* double(get_bytes(socket, 2))); end
  if count == 127, count = sum(256 .^ (7:-1:0) .* double(get_bytes(socket, 8))); end
  bytes = get_bytes(socket, count);
end

function bytes = get_bytes(socket, count)
  bytes = zeros(1, 0, 'uint8');
  while numel(bytes) < count, bytes = [bytes, uint8(read(socket, count - numel(bytes)))]; end
end
