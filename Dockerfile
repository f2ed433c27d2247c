# Training, reports and the viewer on a CPU, with a software OpenGL for pictures.
#
#   docker build -t mini-quadruped .
#   docker run --rm -it -v "$PWD:/work" mini-quadruped train
#   docker run --rm -it -v "$PWD:/work" -p 127.0.0.1:8080:8080 mini-quadruped view --host 0.0.0.0
#
# By itself the viewer listens within the container only; --host 0.0.0.0 lets it be published, here on this machine alone.
FROM python:3.12-slim

# hadolint ignore=DL3008
RUN apt-get update \
    && apt-get install -y --no-install-recommends libegl1 libgl1-mesa-dri \
    && rm -rf /var/lib/apt/lists/*

COPY . /source
RUN pip install --no-cache-dir -c /source/constraints.txt torch --index-url https://download.pytorch.org/whl/cpu \
    && pip install --no-cache-dir -c /source/constraints.txt "/source[train,report,viewer,ros,export]" \
    && useradd --create-home --uid 1000 robot

USER 1000
WORKDIR /work
EXPOSE 8080
ENTRYPOINT ["mini-quadruped"]
CMD ["--help"]
