"""A running scene, from Python: listen to its ticks and say what the stylus is held to.

`underact-cli serve` is the other end; the guide's page "Live service" has the wire. `connect()` is
for scripts and notebooks, `connect_async()` for asyncio. Both take python3-websockets.
"""

from __future__ import annotations

import asyncio
import contextlib
import hashlib
import hmac
import importlib
import json
import os
import secrets
import threading
from collections import deque
from collections.abc import AsyncIterator, Coroutine, Iterator, Sequence
from pathlib import Path
from types import TracebackType
from typing import Any, TypeVar, Union

import numpy as np
import numpy.typing as npt

PORT = 7171

#: A value of a setting: a number, one for each axis, a word, or true or false.
Value = Union[float, str, bool, Sequence[float]]
#: A message of ticks: column -> one row for each tick.
Ticks = dict[str, npt.NDArray[np.float64]]
_Answer = dict[str, Any]
_T = TypeVar("_T")

_MAX_EVENTS = 10_000  # that wait to be read; the oldest are dropped
_MAX_MESSAGES = 1_000  # of ticks that wait to be read
_ANSWER_WITHIN_S = 60.0  # a scene with a large mesh takes seconds to be read


class LiveError(Exception):
    """The service is not there, or has gone. `str()` is a sentence with the way out."""


class Refused(LiveError):
    """The service refuses a request. `problems`: (path, sentence) of each."""

    def __init__(self, problems: list[tuple[str, str]]):
        super().__init__(
            " ".join(f"{path}: {sentence}" if path else sentence for path, sentence in problems)
        )
        self.problems = problems


def token_path(port: int = PORT) -> Path:
    """The file in which `underact-cli serve` puts its token, if it is not told another."""
    runtime = os.environ.get("XDG_RUNTIME_DIR", "")
    folder = Path(runtime) if runtime.startswith("/") else Path.home() / ".cache/underact"
    return folder / ("underact" if runtime.startswith("/") else "runtime") / f"serve-{port}.token"


def _token(token: str | None, token_file: str | Path | None, port: int) -> str:
    if token is not None:
        return token
    path = Path(token_file) if token_file is not None else token_path(port)
    try:
        return path.read_text(encoding="utf-8").strip()
    except OSError as error:
        raise LiveError(
            f"The token cannot be read from {path} ({error.strerror}). Start "
            '"underact-cli serve", or give token_file= what it prints.'
        ) from error


class Columns:
    """How the packed rows of a subscription are cut into columns."""

    def __init__(self, described: list[dict[str, Any]]):
        self.units: dict[str, str] = {one["name"]: one["unit"] for one in described}
        self._widths: dict[str, int] = {one["name"]: one["width"] for one in described}

    def unpack(self, frame: bytes) -> Ticks:
        """Columns of a width of 1 have a number for each tick, others a row."""
        count = int.from_bytes(frame[:8], "little")
        rows = np.frombuffer(frame, "<f8", offset=8).reshape(count, sum(self._widths.values()))
        ticks: Ticks = {}
        at = 0
        for name, width in self._widths.items():
            ticks[name] = rows[:, at] if width == 1 else rows[:, at : at + width]
            at += width
        return ticks


class AsyncLive:
    """A connection for asyncio; made by `connect_async()`."""

    def __init__(self, socket: Any):
        self._socket = socket
        self._next = 0
        self._waiting: dict[int, asyncio.Future[_Answer]] = {}
        self._ticks: asyncio.Queue[Ticks | None] = asyncio.Queue(_MAX_MESSAGES)
        self._columns: Columns | None = None
        self._reader = asyncio.ensure_future(self._read())
        #: What the service told: {"event": "fault", "mode", "edit", "mark", "lag" or "lease", ...}
        self.events: deque[dict[str, Any]] = deque(maxlen=_MAX_EVENTS)
        #: Rows that this client was too slow for.
        self.lost = 0
        #: The answer to hello: program, arm, rate_hz, force_limit_N, ...
        self.about: dict[str, Any] = {}

    async def __aenter__(self) -> AsyncLive:
        return self

    async def __aexit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        await self.close()

    async def close(self) -> None:
        """Ends the connection: the lease ends, and the force; the scene stays."""
        await self._socket.close()
        await asyncio.wait({self._reader}, timeout=5.0)

    async def _read(self) -> None:
        try:
            async for frame in self._socket:
                if isinstance(frame, bytes):
                    if self._columns is not None:
                        self._keep(self._columns.unpack(frame))
                else:
                    self._take(json.loads(frame))
        except Exception:  # the connection broke: whoever waits is told so below
            pass
        for future in self._waiting.values():
            if not future.done():
                future.set_exception(LiveError("The service has closed the connection."))
        self._waiting.clear()
        self._keep(None)

    def _take(self, message: dict[str, Any]) -> None:
        if "event" in message:
            if message["event"] == "lag":
                self.lost += int(message["rows"])
            self.events.append(message)
            return
        future = self._waiting.pop(message["id"], None) if message.get("id") is not None else None
        if future is not None and not future.done():
            future.set_result(message)

    def _keep(self, ticks: Ticks | None) -> None:
        if self._ticks.full():
            dropped = self._ticks.get_nowait()
            self.lost += len(dropped["tick"]) if dropped is not None else 0
        self._ticks.put_nowait(ticks)

    async def request(self, do: str, **keys: Any) -> _Answer:
        """Any request of the wire; its answer. Raises Refused with the service's sentences."""
        number = self._next
        self._next += 1
        future: asyncio.Future[_Answer] = asyncio.get_running_loop().create_future()
        self._waiting[number] = future
        try:
            await self._socket.send(json.dumps({"id": number, "do": do, **keys}, allow_nan=False))
        except LiveError:
            raise
        except Exception as error:
            self._waiting.pop(number, None)
            if not future.cancel():
                future.exception()  # has been told, if not here
            if isinstance(error, (TypeError, ValueError)):
                raise
            raise LiveError("The service has closed the connection.") from error
        try:
            answer = await asyncio.wait_for(future, _ANSWER_WITHIN_S)
        except asyncio.TimeoutError as error:
            raise LiveError(f'The service has not answered "{do}" within a minute.') from error
        if not answer["ok"]:
            raise Refused([(one["path"], one["sentence"]) for one in answer["problems"]])
        return answer

    async def get(self, *paths: str) -> list[Any]:
        """The values of settings, by their paths."""
        return list((await self.request("get", paths=list(paths)))["values"])

    async def set(self, values: dict[str, Value]) -> int:
        """Sets all of them at one tick, or none; the tick."""
        return int((await self.request("set", values=values))["tick"])

    async def settings(self) -> dict[str, dict[str, Any]]:
        """path -> type, unit, min, max, default, value, applies, label."""
        return {one["path"]: one for one in (await self.request("settings"))["settings"]}

    async def scene(self) -> dict[str, Any]:
        """The scene, as in a scene file."""
        return dict((await self.request("scene"))["scene"])

    async def load(self, scene: str | Path | dict[str, Any]) -> int:
        """Another scene: an object as in a scene file, a path, or the name of a shipped scene."""
        if isinstance(scene, dict):
            return int((await self.request("load", scene=scene))["tick"])
        name = str(scene)
        if "/" in name or Path(name).exists():
            name = str(Path(name).resolve())
        return int((await self.request("load", file=name))["tick"])

    async def start(self) -> int:
        return int((await self.request("start"))["tick"])

    async def stop(self) -> int:
        return int((await self.request("stop"))["tick"])

    async def mark(self, text: str) -> int:
        """A marker in the session; its tick."""
        return int((await self.request("mark", text=text))["tick"])

    async def force(self, f_N: Sequence[float], for_ms: float = 50.0) -> int:
        """Adds a force in W before the safety gate, for a while."""
        numbers = [float(one) for one in f_N]
        return int((await self.request("force", f_N=numbers, for_ms=for_ms))["tick"])

    async def add(self, constraint: dict[str, Any]) -> int:
        """One more constraint, as in a scene file."""
        return int((await self.request("constraint.add", constraint=constraint))["tick"])

    async def remove(self, name: str) -> int:
        return int((await self.request("constraint.remove", name=name))["tick"])

    async def move(self, name: str, over_ms: float = 0.0, **values: Any) -> int:
        """Moves a constraint, `center_mm=[0, 0, 10]` say, within that time."""
        plain = {key: _plain(value) for key, value in values.items()}
        answer = await self.request("constraint.move", name=name, values=plain, over_ms=over_ms)
        return int(answer["tick"])

    async def record(self, file: str) -> str:
        """Records into a new file of the sessions folder; its path."""
        return str((await self.request("record", file=file))["file"])

    async def stop_recording(self) -> int:
        """The number of its ticks."""
        return int((await self.request("record", stop=True))["ticks"])

    async def take_lease(self) -> None:
        await self.request("lease", lease="take")

    async def give_lease(self) -> None:
        await self.request("lease", lease="give")

    async def status(self) -> dict[str, Any]:
        return await self.request("status")

    async def subscribe(self, columns: Sequence[str], hz: float) -> Columns:
        """From now on `next_ticks()` has these columns of a session."""
        answer = await self.request("subscribe", columns=list(columns), hz=hz, format="binary")
        self._columns = Columns(answer["columns"])
        return self._columns

    async def next_ticks(self) -> Ticks:
        """The ticks that came since the last call, at least one."""
        ticks = await self._ticks.get()
        if ticks is None:
            raise LiveError("The service has closed the connection.")
        return ticks

    async def ticks(self, columns: Sequence[str], hz: float) -> AsyncIterator[Ticks]:
        """Ticks as they come, until the loop over them is left."""
        await self.subscribe(columns, hz)
        try:
            while True:
                yield await self.next_ticks()
        finally:
            with contextlib.suppress(LiveError):  # the connection may have gone before the loop
                await self.request("unsubscribe")


def _plain(value: Any) -> Any:
    """An array of numpy as the list that JSON has."""
    return value.tolist() if isinstance(value, (np.ndarray, np.generic)) else value


async def _challenge(live: AsyncLive, secret: str, address: str) -> None:
    """Any program may listen at a port that is free, and wait for the tokens of others."""
    nonce = secrets.token_hex(32)
    proof = hmac.new(secret.encode(), nonce.encode(), hashlib.sha256).hexdigest()
    try:
        answer = str((await live.request("challenge", nonce=nonce))["proof"])
    except (Refused, KeyError, TypeError):
        answer = ""
    if not hmac.compare_digest(answer.encode(errors="replace"), proof.encode()):
        sentence = (
            f"Whoever listens at {address} does not know this token, so it was not sent. Give the "
            'port and the token_file= that "underact-cli serve" prints.'
        )
        raise Refused([("/token", sentence)])


async def connect_async(
    url: str | None = None,
    *,
    port: int = PORT,
    token: str | None = None,
    token_file: str | Path | None = None,
    name: str = "python",
) -> AsyncLive:
    """A connection for asyncio: `async with await connect_async() as live:`.

    Without a token it is read from the file where `underact-cli serve` puts it. It goes to nobody
    who does not prove to know it, which raises Refused.
    """
    try:
        websockets: Any = importlib.import_module("websockets")  # its names are made when asked for
    except ModuleNotFoundError as error:
        raise LiveError("Python has no websockets. Install python3-websockets.") from error
    secret = _token(token, token_file, port)
    address = url if url is not None else f"ws://127.0.0.1:{port}"
    try:
        socket = await websockets.connect(address, max_size=None, compression=None)
    except (OSError, asyncio.TimeoutError, websockets.exceptions.WebSocketException) as error:
        raise LiveError(
            f'Nobody serves a scene at {address} ({error}). Start "underact-cli serve".'
        ) from error
    live = AsyncLive(socket)
    try:
        await _challenge(live, secret, address)
        live.about = await live.request("hello", token=secret, name=name)
    except BaseException:
        await live.close()
        raise
    return live


class Settings:
    """The settings of the scene by their paths: `live.settings["/control/kp_N_per_mm"] = 0.3`.

    A notebook completes the paths.
    """

    def __init__(self, live: Live):
        self._live = live

    def __getitem__(self, path: str) -> Any:
        return self._live.get(path)[0]

    def __setitem__(self, path: str, value: Value) -> None:
        self._live.set({path: value})

    def __iter__(self) -> Iterator[str]:
        return iter(self.table())

    def __len__(self) -> int:
        return len(self.table())

    def table(self) -> dict[str, dict[str, Any]]:
        """path -> type, unit, min, max, default, value, applies, label."""
        return self._live._wait(self._live._async.settings())

    def _ipython_key_completions_(self) -> list[str]:
        return list(self.table())


class Live:
    """A connection for scripts and notebooks; made by `connect()`."""

    def __init__(self, live: AsyncLive, loop: asyncio.AbstractEventLoop, thread: threading.Thread):
        self._async = live
        self._loop = loop
        self._thread = thread
        self.settings = Settings(self)

    def __enter__(self) -> Live:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def _wait(self, work: Coroutine[Any, Any, _T]) -> _T:
        return asyncio.run_coroutine_threadsafe(work, self._loop).result()

    def close(self) -> None:
        """Ends the connection: the lease ends, and the force; the scene stays."""
        if not self._thread.is_alive():
            return
        self._wait(self._async.close())
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()

    @property
    def about(self) -> dict[str, Any]:
        """The answer to hello: program, arm, rate_hz, force_limit_N, ..."""
        return self._async.about

    @property
    def events(self) -> deque[dict[str, Any]]:
        """What the service told: faults, modes, edits, marks, lag, the lease."""
        return self._async.events

    @property
    def lost(self) -> int:
        """Rows that this client was too slow for."""
        return self._async.lost

    def request(self, do: str, **keys: Any) -> _Answer:
        """Any request of the wire; its answer. Raises Refused with the service's sentences."""
        return self._wait(self._async.request(do, **keys))

    def get(self, *paths: str) -> list[Any]:
        """The values of settings, by their paths."""
        return self._wait(self._async.get(*paths))

    def set(self, values: dict[str, Value]) -> int:
        """Sets all of them at one tick, or none; the tick."""
        return self._wait(self._async.set(values))

    def scene(self) -> dict[str, Any]:
        """The scene, as in a scene file."""
        return self._wait(self._async.scene())

    def load(self, scene: str | Path | dict[str, Any]) -> int:
        """Another scene: an object as in a scene file, a path, or the name of a shipped scene."""
        return self._wait(self._async.load(scene))

    def start(self) -> int:
        return self._wait(self._async.start())

    def stop(self) -> int:
        return self._wait(self._async.stop())

    def mark(self, text: str) -> int:
        """A marker in the session; its tick."""
        return self._wait(self._async.mark(text))

    def force(self, f_N: Sequence[float], for_ms: float = 50.0) -> int:
        """Adds a force in W before the safety gate, for a while."""
        return self._wait(self._async.force(f_N, for_ms))

    def add(self, constraint: dict[str, Any]) -> int:
        """One more constraint, as in a scene file."""
        return self._wait(self._async.add(constraint))

    def remove(self, name: str) -> int:
        return self._wait(self._async.remove(name))

    def move(self, name: str, over_ms: float = 0.0, **values: Any) -> int:
        """Moves a constraint, `center_mm=[0, 0, 10]` say, within that time."""
        return self._wait(self._async.move(name, over_ms, **values))

    def record(self, file: str) -> str:
        """Records into a new file of the sessions folder; its path."""
        return self._wait(self._async.record(file))

    def stop_recording(self) -> int:
        """The number of its ticks."""
        return self._wait(self._async.stop_recording())

    def take_lease(self) -> None:
        self._wait(self._async.take_lease())

    def give_lease(self) -> None:
        self._wait(self._async.give_lease())

    def status(self) -> dict[str, Any]:
        return self._wait(self._async.status())

    def ticks(self, columns: Sequence[str], hz: float) -> Iterator[Ticks]:
        """Ticks as they come, until the loop over them is left."""
        self._wait(self._async.subscribe(columns, hz))
        try:
            while True:
                yield self._wait(self._async.next_ticks())
        finally:
            if self._thread.is_alive():
                with contextlib.suppress(LiveError):
                    self._wait(self._async.request("unsubscribe"))


def connect(
    url: str | None = None,
    *,
    port: int = PORT,
    token: str | None = None,
    token_file: str | Path | None = None,
    name: str = "python",
) -> Live:
    """A connection for scripts and notebooks: `with underact.connect() as live:`.

    Without a token it is read from the file where `underact-cli serve` puts it. It goes to nobody
    who does not prove to know it, which raises Refused.
    """
    loop = asyncio.new_event_loop()
    thread = threading.Thread(target=loop.run_forever, name="underact.live", daemon=True)
    thread.start()
    work = connect_async(url, port=port, token=token, token_file=token_file, name=name)
    try:
        live = asyncio.run_coroutine_threadsafe(work, loop).result()
    except BaseException:
        loop.call_soon_threadsafe(loop.stop)
        thread.join()
        loop.close()
        raise
    return Live(live, loop, thread)
